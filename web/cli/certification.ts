/** What `certify` prints of one element: its certificate, docs/certificates.md, or why there is none. */
import { certificateJson, certify } from '../core/exact/certificate'
import type { Core } from '../core/report'
import type { NamedHexahedron } from './read-hexahedra'

export function certification(core: Core, { name, vertices }: NamedHexahedron): object {
  const verdict = core.isValid(vertices)
  return verdict.ok ? certificateJson(name, vertices, certify(vertices)) : { name, error: verdict.error.message }
}
