/**
 * `hexlens/core`: verdicts, reports and proofs without the element, in Node, Deno, a worker or a page. Nothing here touches a DOM.
 *
 *     const core = await loadCore()
 *     const result = core.analyze(vertices)   // { ok: true, value: Report } or { ok: false, error: CoreError }
 */

import { type Certificate, certificateOf } from '../core/exact/certificate'
import { fetchCore } from '../core/fetch-core'
import type { Result, Core as WasmCore } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import { coreInside } from './core-inside'

export { type Certificate, certificateJson } from '../core/exact/certificate'
export type * from '../core/report'
export { reportJson } from '../core/report-json'
export type { Vec3, Vertices } from '../model/hexahedron'
export { decodePermalink, encodePermalink, type PermalinkResult } from '../model/permalink'
export { type Preset, presets, presetVertices } from '../model/presets'

/** The C core, and proofs by exact arithmetic in JavaScript. */
export interface Core extends WasmCore {
  /** A proof of the verdict that anyone can check: docs/certificates.md. */
  certificate(vertices: Vertices): Result<Certificate>
}

/** Rejects, with a sentence, where neither WebAssembly nor its twin starts. */
export async function loadCore(): Promise<Core> {
  const core = await fetchCore(coreInside)
  return { ...core, certificate: vertices => certificateOf(core, vertices) }
}
