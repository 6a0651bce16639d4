/** Proofs about the places of a vertex as files, by the checker that shares nothing with what made them. */
import { expect, it } from 'vitest'
import type { Star } from '../../web/core/repair/best-place'
import { placeCertificateJson } from '../../web/core/repair/place-certificate'
import { provePlace } from '../../web/core/repair/place-proof'
import { presets, presetVertices } from '../../web/model/presets'
import { checked, type Loose } from './certificate-checker'
import { randomHexahedron, unitCube } from './core-fixtures'
import { randomSource } from './random'
import { bestOf, noisyStars, starOf } from './stars'

function fileOf(name: string, star: Star): Loose {
  const best = bestOf(star)
  const json = placeCertificateJson(name, [], star, best, provePlace(star, best))
  if (!json) throw new Error(`${name}: nothing is proved.`)
  return JSON.parse(JSON.stringify(json))
}

const random = randomSource(21)
const valid = noisyStars(22, 0.1, 0.5)()
const singles = Array.from(
  { length: 6 },
  (_, n): Star => ({
    hexahedra: randomHexahedron(random, n < 3 ? 0.2 : 0.6),
    moving: [[n % 8]],
  }),
)
const wedge: Star = { hexahedra: unitCube.with(9, 0).with(10, 0).with(21, 0).with(22, 0), moving: [[0, 3]] }

it('holds for single elements, stars, repeated nodes and presets', () => {
  const hard = noisyStars(23, 0.25, 0.5)
  const stars = [...singles, ...Array.from({ length: 3 }, hard), valid, wedge, starOf(x => x)]
  const files = stars.map((star, i) => fileOf(String(i), star))
  const ofPresets = presets
    .slice(0, 6)
    .map((preset, i) => fileOf(preset.id, { hexahedra: presetVertices(preset), moving: [[i % 8]] }))
  const all = [...files, ...ofPresets]
  expect(checked(JSON.stringify(all))).toMatchObject({ status: 0, output: `${all.length} certificates hold\n` })
  expect(new Set(files.map(({ holds }) => holds.length))).toEqual(new Set([0, 1, 4]))
  expect(files.some(({ level }) => level === '0')).toBe(true)
  // Names of cells, and only those that hold the vertex.
  const best = bestOf(valid)
  const names = ['a', 'b', 'c', 'd', 'e', 'f', 'g', 'h']
  const named = placeCertificateJson('v', names, valid, best, provePlace(valid, best)) as Loose
  const held = new Set(best.holds.map(({ cell }) => names[cell as number]))
  expect(new Set(named.cells.map((cell: Loose) => cell.name))).toEqual(held)
})

it('is refused when it was tampered with', () => {
  const file = fileOf('star', valid)
  const forbidden = fileOf('wedge', wedge)
  const changes: readonly [string, (entry: Loose) => void, Loose?][] = [
    ['the weighted sum depends on the place', entry => Object.assign(entry, { level: '1/8' })],
    ['the weighted sum depends on the place', entry => Object.assign(entry.holds[0], { weight: '1/7' })],
    ['the weighted sum depends on the place', entry => entry.holds.pop()],
    // On a face that does not move jacdet is the same for every place, as it was at this hold.
    ['the weighted sum is positive', entry => Object.assign(entry.holds[1], { point: ['1/3', '0', '1'] })],
    ['the weighted sum depends on the place', entry => Object.assign(entry.holds[2], { point: ['1/3', '1', '1'] })],
    ['what moves is not at one place', entry => Object.assign(entry.cells[0], { moving: [0, 6] })],
    ['a weight is not positive', entry => Object.assign(entry.holds[0], { weight: '-1/7' })],
    ['nothing holds', entry => Object.assign(entry, { holds: [] })],
    ['a hold is in none of the cells', entry => Object.assign(entry.holds[0], { cell: 9 })],
    ['a hold is in none of the cells', entry => Object.assign(entry.holds[0], { cell: '0' })],
    ['a point is not in the closed cube', entry => Object.assign(entry.holds[0], { point: ['2', '0', '0'] })],
    ['in a cell nothing moves', entry => Object.assign(entry.cells[0], { moving: [] })],
    ['what moves is no vertex', entry => Object.assign(entry.cells[0], { moving: [8] })],
    ['there are no cells, or the level is negative', entry => Object.assign(entry, { level: '-1' })],
    ['"bySign" is not of the kind', entry => Object.assign(entry.holds[0], { bySign: 1 })],
    ['the weighted sum is positive', entry => reversed(entry), forbidden],
  ]
  for (const [why, change, of = file] of changes) {
    const entry = structuredClone(of)
    change(entry)
    const { status, output } = checked(JSON.stringify([entry]))
    expect(output).toContain(why)
    expect(status).toBe(1)
  }
  // A list of elements says nothing about stars.
  expect(checked(JSON.stringify([file]), JSON.stringify([{ name: 'star', vertices: [] }])).status).toBe(1)
})

/** One hold at a vertex where jacdet is positive, for every place. */
function reversed(entry: Loose): void {
  entry.holds = [{ cell: 0, point: ['1', '1', '1'], weight: '1' }]
  entry.cells[0].moving = [0, 3]
}
