/** Tells the page where the reader looks, and what is pointed at: `hex-camera` and `hex-probe`. */
import type { JacobianReport } from '../core/report'
import type { CameraView } from '../model/state'
import type { ProbeDetail } from './events'

export interface LookListener {
  tell(event: 'hex-camera', camera: CameraView): void
  tell(event: 'hex-probe', probe: ProbeDetail | null): void
}

export class Looking {
  /** The camera as the reader last left it; null before the first picture. */
  camera: CameraView | null = null
  /** True if the camera has moved since it was last told. It is relative to the element: that moves, too. */
  hasTurned = false
  readonly #listener: LookListener
  #probe: JacobianReport | null = null

  constructor(listener: LookListener) {
    this.#listener = listener
  }

  /** Called after each picture; `camera` gives null while the picture does not look as was asked for. */
  tell(camera: () => CameraView | null, probe: JacobianReport | null): void {
    const isFirst = this.camera === null
    const now = this.hasTurned || isFirst ? camera() : null
    if (now) {
      this.hasTurned = false
      const isOther = JSON.stringify(now) !== JSON.stringify(this.camera)
      if (isOther) this.camera = now
      if (isOther && !isFirst) this.#listener.tell('hex-camera', now)
    }
    if (isSame(probe, this.#probe)) return
    this.#probe = probe
    if (probe === null) this.#listener.tell('hex-probe', null)
    else {
      const { point, position, jacdet, exponent } = probe
      this.#listener.tell('hex-probe', { point, position, jacdet, exponent })
    }
  }
}

/** All else of a point's report comes from these. */
function isSame(a: JacobianReport | null, b: JacobianReport | null): boolean {
  const key = (probe: JacobianReport | null) =>
    probe && JSON.stringify([probe.point, probe.position, probe.jacdet, probe.exponent])
  return key(a) === key(b)
}
