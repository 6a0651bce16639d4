/** What `certify` writes: a JSON list with a certificate for each element, docs/certificates.md, or why there is none. */
import { certificateJson, certify } from '../core/exact/certificate'
import type { Core } from '../core/report'
import type { MeshCheck } from '../mesh/mesh-check'
import { verticesOf } from '../mesh/vertices-of'
import type { Vertices } from '../model/hexahedron'
import { invalidCells, nameOf } from './invalid-cells'
import { jsonList, jsonText } from './json-text'

export function certification(
  core: Core,
  { name, vertices }: { readonly name: string; readonly vertices: Vertices },
): object {
  const verdict = core.isValid(vertices)
  return verdict.ok ? certificateJson(name, vertices, certify(vertices)) : { name, error: verdict.error.message }
}

/** The invalid cells' certificates, by their ids, in the file's order. */
export function* invalidCertificates(check: MeshCheck, core: Core): Generator<string> {
  const cells = invalidCells(check)
  for (const [i, cell] of cells.entries()) {
    const hexahedron = { name: nameOf(check, cell), vertices: verticesOf(check.mesh, cell) }
    yield `${jsonList.before(i)}${jsonText(certification(core, hexahedron))}`
  }
  yield jsonList.end(cells.length)
}
