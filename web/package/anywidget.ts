/**
 * The element as the front end of a Jupyter widget (anywidget's `render`). `vertices` goes both ways as the bytes of 24 doubles, little
 * end first, so every bit arrives; the verdict goes to Python once a change is done.
 */
import './hexlens'
import { sameBits } from '../model/hexahedron'
import { setMeshWorker } from './mesh-worker-beside'

type Lens = HTMLElementTagNameMap['hex-lens']

interface Model {
  get(name: string): unknown
  set(name: string, value: unknown): void
  save_changes(): void
  on(event: string, listener: Listener): void
  off(event: string, listener: Listener): void
  send(content: unknown): void
}

type Listener = (content?: unknown, buffers?: readonly DataView[]) => void

/** Milliseconds that the kernel may take to answer. */
const PATIENCE_MS = 30_000

const ATTRIBUTES = ['views', 'controls', 'camera', 'theme', 'label', 'app']

/** Nothing lies beside a notebook's script: the kernel sends the one that reads. */
function meshWorkerFrom(model: Model): Promise<string> {
  return new Promise((resolve, reject) => {
    const end = () => {
      clearTimeout(deadline)
      model.off('msg:custom', onMessage)
    }
    const onMessage: Listener = (content, buffers) => {
      const [bytes] = buffers ?? []
      if (content !== 'mesh-worker' || !bytes) return
      end()
      resolve(URL.createObjectURL(new Blob([bytes as DataView<ArrayBuffer>], { type: 'text/javascript' })))
    }
    const deadline = setTimeout(() => {
      end()
      reject(new Error('the notebook’s kernel, which has its script, does not answer'))
    }, PATIENCE_MS)
    model.on('msg:custom', onMessage)
    model.send('mesh-worker')
  })
}

function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  const lens = document.createElement('hex-lens') as Lens
  for (const name of ATTRIBUTES) {
    const value = model.get(name)
    if (typeof value === 'string' && value !== '') lens.setAttribute(name, value)
  }
  if (model.get('readonly') === true) lens.setAttribute('readonly', '')
  lens.style.minHeight = `${model.get('height')}px`
  lens.style.setProperty('--hl-aspect-ratio', 'auto')

  const toLens = () => {
    const vertices = doublesOf(model.get('vertices') as DataView)
    if (sameBits(vertices, lens.vertices)) return
    lens.vertices = vertices
    if (lens.report) tellVerdict()
  }
  const toPython = () => {
    model.set('vertices', bytesOf(lens.vertices))
    tellVerdict()
  }
  const tellVerdict = () => {
    const { report } = lens
    model.set('valid', report?.valid ?? null)
    model.set('boundary_minimum', report && report.exponent === 0 ? report.boundaryMinimum : null)
    model.save_changes()
  }
  setMeshWorker(() => meshWorkerFrom(model))
  toLens()
  model.on('change:vertices', toLens)
  lens.addEventListener('hex-change', toPython)
  lens.addEventListener('hex-verdict', tellVerdict)
  el.append(lens)
  return () => {
    model.off('change:vertices', toLens)
    lens.remove()
  }
}

function doublesOf(bytes: DataView): number[] {
  return Array.from({ length: bytes.byteLength / 8 }, (_, i) => bytes.getFloat64(8 * i, true))
}

function bytesOf(vertices: readonly number[]): DataView {
  const bytes = new DataView(new ArrayBuffer(8 * vertices.length))
  vertices.forEach((value, i) => {
    bytes.setFloat64(8 * i, value, true)
  })
  return bytes
}

export default { render }
