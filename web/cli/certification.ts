/** The output of `certify` for one element: its certificate, or why there is none. */
import { certificateJson, certify } from '../core/exact/certificate'
import type { Core } from '../core/report'
import type { NamedHexahedron } from './read-hexahedra'

export function certification(core: Core, { name, vertices }: NamedHexahedron): object {
  const verdict = core.isValid(vertices)
  return verdict.ok ? certificateJson(name, vertices, certify(vertices)) : { name, error: verdict.error.message }
}
