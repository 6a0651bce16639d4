/**
 * What the core says of a state. Each answer is computed when a frame first needs it and kept for as long as it is true; what takes long
 * is computed between gestures, and only while somebody looks at it.
 */
import { type Morph, morphOf } from '../panels/morph/morph-answer'
import type { Core, JacobianReport, Report } from '../core/report'
import { type Surface, zeroSurface } from '../core/zero-surface'
import type { Vertices } from '../model/hexahedron'
import type { State } from '../model/state'
import type { Frame, Proof, TriedOrders } from '../views/view'
import { type PartAnswers, parts } from './parts'
import { triedOrders } from '../panels/node-order/tried-orders'

/** Cells of the grid along each axis from which the surface jacdet = 0 is made, between gestures and in one. */
const SURFACE_CELLS = 24
const GESTURE_SURFACE_CELLS = 8

type Answered = Pick<Frame, 'report' | 'proof' | 'triedOrders' | 'zeroSurface' | 'probe' | 'morph' | 'nearest'>

export class Answers {
  /** Null while it is loading, or if it could not start: then there are no answers. */
  core: Core | null = null
  readonly #onFailure: (message: string) => void
  #analyzed: { readonly vertices: Vertices; readonly report: Report } | null = null
  #proof: Proof | null = null
  #triedOrders: TriedOrders | null = null
  #zeroSurface: { readonly report: Report; readonly cells: number; readonly surface: Surface } | null = null
  #morph: Morph | null = null
  readonly #ofParts: readonly PartAnswers[]

  /**
   * `onFailure` is told, in a sentence, of vertices that the core could not analyse; `onNews` when a part's answers, which may take
   * long, have come further.
   */
  constructor(onFailure: (message: string) => void, onNews: () => void) {
    this.#onFailure = onFailure
    this.#ofParts = parts.flatMap(({ answers }) => (answers ? [answers(onNews)] : []))
  }

  /** Ends what is still being looked for. */
  stop(): void {
    for (const answers of this.#ofParts) answers.stop()
  }

  report(vertices: Vertices): Report | null {
    if (this.core === null) return null
    if (this.#analyzed?.vertices !== vertices) {
      const result = this.core.analyze(vertices)
      this.#analyzed = result.ok ? { vertices, report: result.value } : null
      if (!result.ok) this.#onFailure(result.error.message)
    }
    return this.#analyzed?.report ?? null
  }

  /** All that a frame says of a state. */
  of(state: State): Answered {
    const report = this.report(state.vertices)
    return {
      report,
      proof: this.#proved(state),
      triedOrders: this.#tried(state),
      zeroSurface: this.#surfaced(state, report),
      probe: report && this.probed(state),
      morph: this.#morphed(state),
      nearest: null,
      ...(this.core && Object.assign({}, ...this.#ofParts.map(answers => answers.of(this.core as Core, state)))),
    }
  }

  probed({ vertices, probe }: State): JacobianReport | null {
    const result = probe && this.core?.jacobian(vertices, probe)
    return result?.ok ? result.value : null
  }

  #proved({ vertices, gestureStart, proofShown }: State): Proof | null {
    if (!proofShown || this.#analyzed === null) this.#proof = null
    else if (this.core && this.#proof?.vertices !== vertices && (this.#proof === null || gestureStart === null)) {
      const result = this.core.certificate(vertices)
      this.#proof = result.ok ? { vertices, certificate: result.value } : null
    }
    return this.#proof
  }

  /** Of invalid elements only. */
  #tried({ vertices, gestureStart, openPanels }: State): TriedOrders | null {
    if (!openPanels.includes('node-order') || this.#analyzed === null) this.#triedOrders = null
    else if (this.core && gestureStart === null && this.#triedOrders?.vertices !== vertices)
      this.#triedOrders = this.#analyzed.report.valid ? null : triedOrders(this.core, vertices)
    return this.#triedOrders
  }

  /** Coarser while a gesture runs; what is already finer stays. */
  #surfaced({ faceDisplay, gestureStart }: State, report: Report | null): Surface | null {
    if (faceDisplay !== 'inside' || report === null) return null
    const cells = gestureStart === null ? SURFACE_CELLS : GESTURE_SURFACE_CELLS
    if (this.#zeroSurface?.report !== report || this.#zeroSurface.cells < cells)
      this.#zeroSurface = { report, cells, surface: zeroSurface(report.bernstein, cells) }
    return this.#zeroSurface.surface
  }

  #morphed({ vertices, start, morphA, morphB, gestureStart, openPanels }: State): Morph | null {
    const [a, b] = [morphA ?? start, morphB ?? vertices]
    if (!openPanels.includes('morph') || this.core === null || this.#analyzed === null) this.#morph = null
    else if (gestureStart === null && (this.#morph?.a !== a || this.#morph.b !== b))
      this.#morph = morphOf(this.core, a, b)
    return this.#morph
  }
}
