/** The settings of the picture of a mesh as a text, what they are in another mesh, and the slice's plane and its handle. */
import { describe, expect, test } from 'vitest'
import { outlineOf, turnedTo } from '../../web/mesh-scene/plane-handle'
import type { Vec3 } from '../../web/model/hexahedron'
import {
  cutOf,
  FIRST_SETTINGS,
  flipped,
  invalidCutOf,
  planeOf,
  roundedNormal,
  sliceAt,
} from '../../web/pages/mesh/picture-settings'
import {
  FIRST_LISTING,
  isSettingsText,
  readSettings,
  settingsIn,
  settingsText,
  type Travelling,
} from '../../web/pages/mesh/settings-text'
import { SceneCamera } from '../../web/scene/space/camera'
import type { Overview } from '../../web/survey/survey-jobs'
import { randomSource } from './core-fixtures'

const FIRST: Travelling = {
  of: 7168,
  picture: FIRST_SETTINGS,
  block: null,
  camera: null,
  chosen: null,
  listing: FIRST_LISTING,
}

const EVERYTHING: Travelling = {
  of: 7168,
  picture: {
    set: 'block-1',
    rings: 3,
    slice: { normal: [0.6, -0.8, 1e-5], place: 0.125 },
    relative: [-Infinity, 0.2],
    layers: 4,
    away: [17, 3, 5],
    isApart: true,
    colours: 'invalid',
  },
  block: 'in & out: 50 %, “x=y”',
  camera: { direction: [0.1, -0.2, 0.3], zoom: 1.5, pan: [0, -1e-6, 2] },
  chosen: 12,
  listing: {
    condition: 'not valid and corner_min > 0',
    range: [-2.25, 0.5],
    order: { column: 'accepted-by', isDescending: true },
  },
}

const overview = (hexahedra: number, blocks: string[] = []) =>
  ({ hexahedra, blocks: blocks.map(name => ({ name, cells: 1 })) }) as unknown as Overview

function read(text: string): Travelling {
  const result = readSettings(text)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('settings as a text', () => {
  test('of the first picture are the mesh alone', () => {
    expect(settingsText(FIRST)).toBe('picture=1&of=7168')
    expect(read('picture=1&of=7168')).toEqual(FIRST)
  })

  test.each([
    ['everything', EVERYTHING],
    ['a range with one end', { ...FIRST, picture: { ...FIRST.picture, relative: [0.1, Infinity] as const } }],
    ['a range with two', { ...FIRST, picture: { ...FIRST.picture, relative: [-1e-7, 1 / 3] as const } }],
    [
      'around the chosen cell',
      { ...FIRST, chosen: 0, picture: { ...FIRST.picture, set: 'around' as const, rings: 8 } },
    ],
  ])('come back: %s', (_, settings) => {
    const text = settingsText(settings)
    expect(text).toMatch(/^[!-~]+$/)
    expect(read(text)).toEqual(settings)
    expect(read(`https://example.org/mesh.html#${text}`)).toEqual(settings)
    expect(read(` #${text}\n`)).toEqual(settings)
    expect(isSettingsText(`https://example.org/mesh.html#${text}`)).toBe(true)
  })

  test('are told from meshes, and from other fragments', () => {
    for (const text of ['0 0 0 1 0 0', '#cells', '<VTKFile>', 'a picture=1', ''])
      expect(isSettingsText(text)).toBe(false)
    expect(isSettingsText('picture=9')).toBe(true)
  })

  test.each([
    ['picture=2&of=1', 'These settings are of a kind that is not known here: they should begin with picture=1.'],
    ['picture=1', 'These settings do not say of how many hexahedra their mesh is: of= is missing.'],
    ['picture=1&of=8&peel', 'These settings are broken at “peel”.'],
    ['picture=1&of=8&of=8', 'These settings are broken at “of=8”.'],
    ['picture=1&of=8&list=%E4', 'These settings are broken at “list=%E4”.'],
    ['picture=1&of=8&toString=1', '“toString” is no setting of the picture.'],
    ['picture=1&of=8&color=red', '“color” is no setting of the picture.'],
    ['picture=1&of=many', 'The setting of=many should be a number of hexahedra.'],
    [
      'picture=1&of=8&cells=block-0',
      'The setting cells=block-0 should be all, invalid, listed, around or a block, as in block-0:name.',
    ],
    ['picture=1&of=8&rings=9', 'The setting rings=9 should be a whole number from 0 to 8.'],
    [
      'picture=1&of=8&slice=0,0,0,0.5',
      'The setting slice=0,0,0,0.5 should be four numbers, a normal that is not 0 and a place from 0 to 1.',
    ],
    [
      'picture=1&of=8&slice=0,0,1,1.5',
      'The setting slice=0,0,1,1.5 should be four numbers, a normal that is not 0 and a place from 0 to 1.',
    ],
    [
      'picture=1&of=8&relative=2..1',
      'The setting relative=2..1 should be two numbers, as in 0.1..0.5; one of them may be missing.',
    ],
    ['picture=1&of=8&away=1,1', 'The setting away=1,1 should be indices of cells, each once, with commas between.'],
    [
      'picture=1&of=8&camera=1,2,3,0,0,0,0',
      'The setting camera=1,2,3,0,0,0,0 should be seven numbers: a direction, a zoom and a shift.',
    ],
    [
      'picture=1&of=8&sort=up',
      'The setting sort=up should be one of worst, id, block, minimum, volume, class, accepted-by, and perhaps -down.',
    ],
  ])('that are broken are refused in a sentence: %s', (text, sentence) => {
    expect(readSettings(text)).toMatchObject({ ok: false, error: { message: sentence } })
  })
})

describe('settings in another mesh', () => {
  const block = EVERYTHING.block as string

  test('of as many cells, with the same block, are the same', () => {
    expect(settingsIn(EVERYTHING, overview(7168, ['a', block]))).toEqual({ fitting: EVERYTHING, unfit: [] })
  })

  test('find the block by its name', () => {
    const { fitting, unfit } = settingsIn(EVERYTHING, overview(7168, [block]))
    expect([fitting.picture.set, unfit]).toEqual(['block-0', []])
  })

  test('leave out what it cannot have, each with a sentence', () => {
    const { fitting, unfit } = settingsIn(
      { ...EVERYTHING, listing: { ...EVERYTHING.listing, order: { column: 'block', isDescending: false } } },
      overview(603),
    )
    expect(fitting.picture).toEqual({ ...EVERYTHING.picture, set: 'all', away: [] })
    expect([fitting.of, fitting.chosen, fitting.block]).toEqual([603, null, null])
    expect(unfit).toEqual([
      `This mesh has no block “${block}”: all cells are shown.`,
      'This mesh has no blocks to sort by.',
      'Single cells are left out (3 dug away, the chosen one): the settings are of a mesh of 7,168 hexahedra.',
    ])
    expect(settingsIn(FIRST, overview(603)).unfit).toEqual([])
  })

  test('do not name cells that it has not', () => {
    const { fitting, unfit } = settingsIn({ ...FIRST, of: 8, picture: { ...FIRST.picture, away: [8] } }, overview(8))
    expect([fitting.picture.away, unfit.length]).toEqual([[], 1])
  })
})

describe('the cells of the picture', () => {
  test('are cut from a set; the invalid ones of it are seen whatever a slice and peeling take', () => {
    const settings = { ...EVERYTHING.picture, set: 'around' as const }
    const plane = { normal: [1, 0, 0] as const, offset: 1 }
    expect(cutOf(settings, plane, 5)).toMatchObject({
      set: { which: 'around', cell: 5, rings: 3 },
      plane,
      layers: 4,
      away: [17, 3, 5],
      onlyInvalid: false,
    })
    expect(invalidCutOf(settings, 5)).toMatchObject({ plane: null, layers: 0, away: [17, 3, 5], onlyInvalid: true })
    expect(cutOf(settings, null, null).set).toEqual({ which: 'all' })
    expect(invalidCutOf({ ...FIRST_SETTINGS, set: 'invalid' }, null)).toBe(null)
  })
})

describe('the plane of a slice', () => {
  const bounds = { least: [0, -1, 10], greatest: [4, 1, 11] } as const
  const middle: Vec3 = [2, 0, 0.5]
  const next = randomSource(3)

  test('goes from one end of the mesh to the other', () => {
    expect(planeOf({ normal: [2, 0, 0], place: 0 }, middle, bounds)).toEqual({ normal: [1, 0, 0], offset: 0 })
    expect(planeOf({ normal: [2, 0, 0], place: 1 }, middle, bounds)).toEqual({ normal: [1, 0, 0], offset: 4 })
    expect(planeOf({ normal: [0, 0, -1], place: 0.5 }, middle, bounds).offset).toBe(-0.5)
  })

  test('is the slice that it is made of, and its other side is the other side of the same', () => {
    for (let i = 0; i < 100; ++i) {
      const slice = {
        normal: roundedNormal([next() - 0.5, next() - 0.5, next() - 0.5]),
        place: Number(next().toFixed(4)),
      }
      const plane = planeOf(slice, middle, bounds)
      expect(sliceAt({ ...slice, offset: plane.offset }, middle, bounds)).toEqual(slice)
      const other = planeOf(flipped(slice), middle, bounds)
      expect(other.offset).toBeCloseTo(-plane.offset, 12)
      expect(
        Math.hypot(...other.normal.map((value, axis) => value + (plane.normal[axis as 0] as number))),
      ).toBeLessThan(1e-12)
    }
  })

  test('is held within the mesh', () => {
    expect(sliceAt({ normal: [1, 0, 0], offset: 9 }, middle, bounds).place).toBe(1)
    expect(sliceAt({ normal: [1, 0, 0], offset: -9 }, middle, bounds).place).toBe(0)
    expect(sliceAt({ normal: [1, 0, 0], offset: 1 }, middle, null).place).toBe(0.5)
  })
})

describe('the handle of a plane', () => {
  const sides = [-1, 1]
  const corners = sides.flatMap(x => sides.flatMap(y => sides.map((z): Vec3 => [x, y, z])))

  test('its outline is where the plane meets the edges of the box, in order', () => {
    expect(outlineOf(corners, [0, 0, 1], 0.5).map(([, , z]) => z)).toEqual([0.5, 0.5, 0.5, 0.5])
    const third = Math.sqrt(1 / 3)
    const six = outlineOf(corners, [third, third, third], 0)
    expect(six.length).toBe(6)
    const lengths = six.map((point, i) =>
      Math.hypot(...point.map((value, axis) => value - ((six[(i + 1) % 6] as Vec3)[axis as 0] as number))),
    )
    for (const length of lengths) expect(length).toBeCloseTo(Math.SQRT2, 12)
    expect(outlineOf(corners, [0, 0, 1], 3)).toEqual([])
  })

  test('the tip of the normal goes with the pointer, and over the rim to the other side', () => {
    const camera = new SceneCamera()
    camera.resize(800, 600, { top: 0, right: 0, bottom: 0, left: 0 })
    const middle: Vec3 = [0, 0, 0]
    const [right, , back] = camera.axes()
    const { x, y } = camera.project(middle)
    const normalAt = (pixels: number, isFacing: boolean) =>
      turnedTo(camera.ray(x + pixels, y), middle, isFacing, camera)
    const component = (normal: Vec3, axis: Vec3) =>
      normal.reduce((sum, value, i) => sum + value * (axis[i] as number), 0)
    for (const isFacing of [true, false]) {
      const side = isFacing ? 1 : -1
      expect(component(normalAt(0, isFacing), back)).toBeCloseTo(side, 9)
      expect(component(normalAt(32, isFacing), right)).toBeCloseTo(0.5, 2)
      expect(component(normalAt(32, isFacing), back) * side).toBeGreaterThan(0.8)
      expect(component(normalAt(64, isFacing), right)).toBeCloseTo(1, 2)
      expect(component(normalAt(96, isFacing), back) * side).toBeLessThan(-0.6)
      expect(component(normalAt(500, isFacing), back) * side).toBeCloseTo(-1, 6)
    }
  })
})
