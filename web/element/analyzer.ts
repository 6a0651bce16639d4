/**
 * Asks the core about a state. A result is computed when a frame first needs it, and kept for as
 * long as it is true. Slow ones are computed between gestures, and only while they are on the
 * screen.
 */
import type { Core, JacobianReport, Report } from '../core/report'
import { type Surface, zeroSurface } from '../core/zero-surface'
import type { Vertices } from '../model/hexahedron'
import { type State, sliceOf } from '../model/state'
import type { Inquiry, Panel } from '../panels/panel'
import { sceneSlice } from '../views/scene-slices'
import type { Frame } from '../views/view'

/** Cells along each axis of the grid for the surface jacdet = 0, between gestures and in one. */
const SURFACE_CELLS = 24
const GESTURE_SURFACE_CELLS = 8

type Analysis = Pick<Frame, 'report' | 'zeroSurface' | 'probe' | 'answers'>

export class Analyzer {
  /** The core is null while it is loading, or if it could not start: then there are no results. */
  core: Core | null = null
  readonly #onFailure: (message: string) => void
  #analyzed: { readonly vertices: Vertices; readonly report: Report } | null = null
  #zeroSurface: { readonly report: Report; readonly cells: number; readonly surface: Surface } | null = null
  /** Inquiries by the names of the panels that ask. */
  readonly #inquiries: readonly (readonly [string, Inquiry<unknown>])[]

  /**
   * `onFailure` gets a sentence about vertices that the core could not analyse; `onNews` is called
   * when the slow answer to a panel's question has come further.
   */
  constructor(panels: readonly Panel[], onFailure: (message: string) => void, onNews: () => void) {
    this.#onFailure = onFailure
    this.#inquiries = panels.flatMap(({ question }) =>
      question ? [[question.name, question.start(onNews)] as const] : [],
    )
  }

  /** Ends searches that still run. */
  stop(): void {
    for (const [, inquiry] of this.#inquiries) inquiry.stop?.()
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
  analyze(state: State): Analysis {
    const report = this.report(state.vertices)
    return {
      report,
      zeroSurface: this.#surfaced(state, report),
      probe: report && this.probed(state),
      answers: this.#answered(state, report),
    }
  }

  #answered(state: State, report: Report | null): Frame['answers'] {
    const { core } = this
    if (core === null || report === null) return {}
    return Object.fromEntries(this.#inquiries.map(([name, inquiry]) => [name, inquiry.answer(core, state, report)]))
  }

  probed({ vertices, probe }: State): JacobianReport | null {
    const result = probe && this.core?.jacobian(vertices, probe)
    return result?.ok ? result.value : null
  }

  /** A coarser surface while a gesture runs, unless a finer one is there. */
  #surfaced(state: State, report: Report | null): Surface | null {
    if (sliceOf(sceneSlice, state).faceDisplay !== 'inside' || report === null) return null
    const cells = state.gestureStart === null ? SURFACE_CELLS : GESTURE_SURFACE_CELLS
    if (this.#zeroSurface?.report !== report || this.#zeroSurface.cells < cells)
      this.#zeroSurface = { report, cells, surface: zeroSurface(report.bernstein, cells) }
    return this.#zeroSurface.surface
  }
}
