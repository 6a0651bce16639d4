/** Certificates of the points that hold what untangling has left, for a checker: docs/certificates.md, section 5. */
import type { Reason } from '../core/repair/held'
import { placeCertificateJson } from '../core/repair/place-certificate'
import { jsonList, jsonText } from './json-text'

/**
 * Writes a list with a certificate for each reason that has one, and returns how many have. `indexOf` is a point's index in the mesh,
 * `nameOf` a cell's name, both by their indices in what was untangled.
 */
export function writeHeldCertificates(
  reasons: Iterable<Reason>,
  { indexOf, nameOf }: { indexOf(point: number): number; nameOf(cell: number): string },
  write: (text: string) => void,
): number {
  let count = 0
  for (const { point, vertex, cells, star, best, proof, forbids } of reasons) {
    const names = cells.map(nameOf)
    const name = `point ${indexOf(point)}: vertex ${vertex} of cell ${names[0]}`
    const certificate = forbids && placeCertificateJson(name, names, star, best, proof)
    if (certificate) write(`${jsonList.before(count++)}${jsonText(certificate)}`)
  }
  write(jsonList.end(count))
  return count
}
