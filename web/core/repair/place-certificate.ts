/** A proof about the places of a vertex as the object that is saved, for a checker: docs/certificates.md, section 5. */
import type { Vec3 } from '../../model/hexahedron'
import { fractionText, lowestTerms, type Rational, scaledDouble } from '../../model/rational'
import type { BestPlace, Star } from './best-place'
import { cellsOf, type PlaceProof, type ProvedHold } from './place-proof'

/**
 * `cellNames` are those of the star's cells; only cells that hold the vertex are in it. Null where nothing is proved, or where a side of the
 * box is one of the holds, or the vertex stays in a plane: the claim is about all places. By scale it is the claim that no place makes all cells valid, and null without it.
 */
export function placeCertificateJson(
  name: string,
  cellNames: readonly string[],
  star: Star,
  place: BestPlace,
  proof: PlaceProof,
): object | null {
  if (star.limits?.normals.length) return null
  if (!proof.isProved || (place.measure === 'scale' && !proof.isImpossible)) return null
  const holds = proof.holds.filter((hold): hold is ProvedHold & { cell: number } => hold.cell !== null)
  if (holds.length < proof.holds.length) return null
  const cells = cellsOf(star)
  const used = [...new Set(holds.length === 0 ? cells.keys() : holds.map(({ cell }) => cell))].sort((a, b) => a - b)
  const level = place.measure === 'volume' ? proof.bound : { numerator: 0n, denominator: 1n }
  return {
    name,
    cells: used.map(cell => {
      const { vertices, moving } = cells[cell] as (typeof cells)[number]
      return {
        name: cellNames[cell] ?? String(cell),
        vertices: moving.map((_, v) => vertices.slice(3 * v, 3 * v + 3)),
        moving: [...moving.keys()].filter(v => moving[v]),
      }
    }),
    level: inLowestTerms(level),
    holds: holds.map(({ cell, point, weight, isBySign }) => ({
      cell: used.indexOf(cell),
      point: fractionsOf(point),
      weight: inLowestTerms(weight),
      ...(isBySign ? { bySign: true } : {}),
    })),
  }
}

function inLowestTerms(rational: Rational): string {
  return fractionText(lowestTerms(rational))
}

function fractionsOf(point: Vec3): string[] {
  return point.map(x => inLowestTerms(scaledDouble(x, 0)))
}
