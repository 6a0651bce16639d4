/** The first sentences about a mesh, for people, in the terminal as on a page. */
import type { MeshCheck } from './mesh-check'

/** "15 hexahedra, 10 INVALID, 5 valid." */
export function headline(
  { hexahedra, valid, invalid, unanswered, degenerate }: MeshCheck,
  { skipsDegenerate }: { readonly skipsDegenerate: boolean },
): string {
  const all = counted(hexahedra, 'hexahedron', 'hexahedra')
  if (hexahedra === 0) return 'no hexahedra of eight nodes.'
  if (valid === hexahedra) return hexahedra === 1 ? '1 hexahedron, VALID.' : `${all}, all VALID.`
  const parts = [
    invalid > 0 ? `${invalid} INVALID` : null,
    valid > 0 ? `${valid} valid` : null,
    unanswered > 0 ? `${unanswered} unanswered` : null,
    skipsDegenerate && degenerate > 0 ? `${degenerate} degenerate` : null,
  ]
  return `${all}, ${parts.filter(part => part !== null).join(', ')}.`
}

/** Sentences under the headline: coincident vertices, and cells that are not hexahedra. */
export function countSentences(
  { degenerate, mesh }: MeshCheck,
  { skipsDegenerate }: { readonly skipsDegenerate: boolean },
): string[] {
  const sentences: string[] = []
  if (degenerate > 0) {
    const cells = counted(degenerate, 'hexahedron has', 'hexahedra have')
    sentences.push(
      `${cells} coincident vertices${skipsDegenerate ? ' and count neither as valid nor as invalid' : ''}.`,
    )
  }
  if (mesh.other.size > 0)
    sentences.push(`Not checked: ${[...mesh.other].map(([type, count]) => ofType(count, type)).join(', ')}.`)
  return sentences
}

const PLURALS = new Map([
  ['tetrahedron', 'tetrahedra'],
  ['polyhedron', 'polyhedra'],
  ['vertex', 'vertices'],
  ['other', 'others'],
])

function ofType(count: number, type: string): string {
  return counted(count, type, PLURALS.get(type) ?? `${type}s`)
}

/** "1 wedge", "2 wedges". */
export function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`
}
