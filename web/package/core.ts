/**
 * `hexlens/core`: verdicts, reports and proofs without the element, in Node, Deno, a worker or a page. Nothing here touches a DOM.
 *
 *     const core = await loadCore()
 *     const result = core.analyze(vertices)   // { ok: true, value: Report } or { ok: false, error: CoreError }
 */

import { fetchCore } from '../core/fetch-core'
import type { Core } from '../core/report'
import { coreInside } from './core-inside'

export { type Certificate, certificateJson } from '../core/exact/certificate'
export type * from '../core/report'
export { reportJson } from '../core/report-json'
export type { Vec3, Vertices } from '../model/hexahedron'
export { decodePermalink, encodePermalink, type PermalinkResult } from '../model/permalink'
export { type Preset, presets, presetVertices } from '../model/presets'

/** Rejects, with a sentence, where neither WebAssembly nor its twin starts. */
export function loadCore(): Promise<Core> {
  return fetchCore(coreInside)
}
