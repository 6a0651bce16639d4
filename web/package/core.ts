/**
 * `hexlens/core`: verdicts, reports and proofs without the element, in Node, Deno, a worker or a page. Nothing here touches a DOM.
 *
 *     const core = await loadCore()
 *     const result = core.analyze(vertices)   // { ok: true, value: Report } or { ok: false, error: CoreError }
 */

export { type Preset, presets, presetVertices } from '../content/presets'
export { type Certificate, certificateJson } from '../core/exact/certificate'
export type * from '../core/report'
export { fetchCore as loadCore } from '../element/fetch-core'
export { reportJson } from '../model/export/report-json'
export type { Vec3, Vertices } from '../model/hexahedron'
export { decodePermalink, encodePermalink, type PermalinkResult } from '../model/permalink'
