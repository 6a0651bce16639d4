import type { CameraView, HexLens, HexLensEventMap, Report } from 'hexlens'
import type { MeshSummary } from 'hexlens/hex-mesh'

const lens = document.createElement('hex-lens')
lens.addEventListener('hex-verdict', ({ detail, currentTarget }) =>
  console.log(detail.valid, detail.source, currentTarget),
)
lens.addEventListener('hex-camera', function ({ detail }) {
  const camera: CameraView = detail
  this.camera = camera
})
lens.addEventListener('pointerdown', event => event.pointerId)
lens.addEventListener('anything', event => event.type)
const listener = (event: HexLensEventMap['hex-probe']): number | undefined => event.detail?.point[0]
lens.addEventListener('hex-probe', listener)
lens.removeEventListener('hex-probe', listener)
// @ts-expect-error There is no such thing in a verdict.
lens.addEventListener('hex-verdict', ({ detail }) => detail.jacdet)
lens.vertices = '0 0 0'
lens.vertices = new Float64Array(24)
lens.hiddenFaces = [1, 2]
lens.highlight({ vertices: [0], edges: 3, faces: [1], point: [0, 0, 0.5] })
lens.highlight()
// @ts-expect-error A face is a number.
lens.highlight({ faces: 'top' })
const arrived: Promise<boolean> = lens.playMorph(lens.vertices, 2, { signal: AbortSignal.timeout(100) })
const report: Report | null = document.querySelector('hex-lens')?.report ?? null
const all: NodeListOf<HexLens> = document.querySelectorAll('hex-lens')

const mesh = document.createElement('hex-mesh')
mesh.addEventListener('hex-pick', function ({ detail }) {
  if (detail.vertices) lens.vertices = detail.vertices
  this.mode = 'invalid'
})
// @ts-expect-error There is no such thing in a mesh.
mesh.addEventListener('hex-open', ({ detail }) => detail.vertices)
const opened: Promise<MeshSummary | null> = mesh.open([new File([], 'part.vtu')])

export { all, arrived, opened, report }
