/** What the page Mesh advises about each sentence that a reader can say. */
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, test } from 'vitest'
import { adviceFor } from '../../web/pages/mesh/advice'

const folder = fileURLToPath(new URL('../../web/mesh/', import.meta.url))

/** A string or a template that stands in a call of `note`, in a push to notes, or is returned by a function for notes; holes are 7. */
const IN_CALLS = /(?:\bnote\(|[nN]otes\.(?:push|add)\()\s*(?:'((?:[^'\\\n]|\\.)+)'|`((?:[^`\\]|\\.)+)`)/g

function sentencesIn(text: string): string[] {
  return [...text.matchAll(IN_CALLS)].map(([, plain, template]) =>
    (plain ?? (template as string)).replaceAll(/\$\{(?:[^{}]|\{[^{}]*\})*\}/g, '7').replaceAll("\\'", "'"),
  )
}

const said = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter(name => name.endsWith('.ts'))
  .flatMap(name => sentencesIn(readFileSync(folder + name, 'utf8')))

/** Those that are made elsewhere than where they are noted. */
const OTHERS = [
  '1 of 15 hexahedra is mirrored, jacdet < 0 everywhere in it, because its nodes are numbered the other way round or an axis is reversed; with nodes 0 to 3 and 4 to 7 exchanged it is valid.',
  '4 hexahedra have coincident vertices.',
  'Not checked: 2 tetrahedra, 1 wedge.',
  '3 cells have more than eight nodes and are not trilinear: by the eight corners 2 would be valid.',
  'Coordinates are printed with at most 7 digits: that can move one by up to 5e-7.',
  'Coordinates are stored as Float32: that can move one by up to 6.0e-8.',
  'The hexahedron with index 0 is unanswered: vertex 6 x is not a finite number.',
  'It is not stated in which order the nodes are: 2 hexahedra are not valid in the order of the text, but in another, first 3 in the order “Lexicographic”.',
  '1 of the voxels (type 11) is no box along the axes in the order of a voxel, first the hexahedron of index 0: they are answered as hexahedra with these corners.',
  'The file is cut off: the answer is for what is whole in it.',
  'There are 3 meshes in this file; they are taken together.',
  'Hexahedra of UCD files are written in two orders, mirror images of each other; these were read bottom first, which makes most of them upright.',
  '2 mirrored hexahedra have been corrected here: nodes 0 to 3 and 4 to 7 are exchanged.',
  'The nodes of all hexahedra have been taken here in the order “Lexicographic” (deal.II).',
  'What was corrected in another step is not corrected here: its cells are others.',
]

test('each has an advice, or is known to need none', () => {
  expect(said.length).toBeGreaterThan(40)
  expect([...said, ...OTHERS].filter(sentence => adviceFor(sentence) === null)).toEqual([])
})

test('an advice is a sentence of its own, and most have one', () => {
  const advices = [...said, ...OTHERS].map(sentence => adviceFor(sentence) ?? '')
  for (const advice of advices) if (advice !== '') expect(advice).toMatch(/^[A-Z].*[.]$/)
  expect(advices.filter(advice => advice !== '').length).toBeGreaterThan(0.7 * advices.length)
})

test('a sentence that nobody knows has none', () => {
  expect(adviceFor('Whatever this may be.')).toBe(null)
})
