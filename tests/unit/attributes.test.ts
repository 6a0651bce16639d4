import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { type AttributeName, readAttribute, readVertices, verticesText, viewNames } from '../../web/element/attributes'
import { HexLensError } from '../../web/element/hex-lens-error'
import { panels } from '../../web/panels/list'
import { unitCube } from './core-fixtures'

function attribute<Name extends AttributeName>(name: Name, text: string | null) {
  return readAttribute(name, text, viewNames({ panels, otherPanels: [] }))
}

function refusalOf(read: () => unknown): string {
  try {
    read()
  } catch (error) {
    if (error instanceof HexLensError) return `${error.code}: ${error.message}`
    throw error
  }
  throw new Error('This was taken.')
}

describe('the attribute vertices', () => {
  it('is written so that every double is read again, bit for bit', () => {
    const double = fc.double({ noNaN: true, noDefaultInfinity: true })
    fc.assert(
      fc.property(fc.array(double, { minLength: 24, maxLength: 24 }), vertices => {
        const again = readVertices(verticesText(vertices))
        expect(again.every((value, i) => Object.is(value, vertices[i]))).toBe(true)
      }),
    )
  })

  it('may have commas, brackets and white space between its numbers', () => {
    const rows = Array.from({ length: 8 }, (_, v) => unitCube.slice(3 * v, 3 * v + 3))
    for (const text of [unitCube.join(' '), unitCube.join(','), JSON.stringify(rows), `\n(${rows.join(');\n(')})`]) {
      expect(readVertices(text)).toEqual(unitCube)
    }
  })

  it('is refused with a sentence', () => {
    const refusals: readonly (readonly [string, RegExp])[] = [
      ['', /^wrong-count: A hexahedron has 24 coordinates; 0 were given\.$/],
      ['1 2 3', /^wrong-count: .*3 were given/],
      [unitCube.with(3, Number.NaN).join(' '), /^bad-attribute: .*“NaN” is not a number/],
      [unitCube.join(' ').replace('1', '0x1'), /^bad-attribute: .*“0x1” is not a number/],
      [unitCube.join(' ').replace('1', '1e999'), /^not-finite: Coordinate 3 is Infinity/],
    ]
    for (const [text, sentence] of refusals) expect(refusalOf(() => readVertices(text))).toMatch(sentence)
  })
})

describe('the other attributes', () => {
  it('have a meaning where they are not there', () => {
    expect(attribute('views', null)).toEqual(['scene', 'verdict'])
    expect(attribute('controls', null)).toEqual(['minimum', 'faces', 'reference', 'turn', 'fit', 'help'])
    expect(attribute('theme', null)).toBe('auto')
    expect([attribute('readonly', null), attribute('readonly', '')]).toEqual([false, true])
    for (const name of ['vertices', 'preset', 'camera', 'poster', 'label'] as const)
      expect(attribute(name, null)).toBeNull()
  })

  it('list words, all or none', () => {
    expect(attribute('views', ' verdict,scene ')).toEqual(['verdict', 'scene'])
    expect(attribute('views', 'all')).toContain('take-away')
    expect(attribute('controls', 'none')).toEqual([])
    expect(attribute('preset', 'cube')?.id).toBe('cube')
  })

  it('say from where to look: azimuth, elevation and zoom', () => {
    expect(attribute('camera', '0 0')).toEqual({ direction: [1, 0, 0], zoom: 1, pan: [0, 0, 0] })
    const view = attribute('camera', '90deg, 45deg, 2.5')
    expect(view?.zoom).toBe(2.5)
    expect(view?.direction[1]).toBeCloseTo(Math.SQRT1_2, 15)
    expect(view?.direction[2]).toBeCloseTo(Math.SQRT1_2, 15)
  })

  it('are refused with a sentence that says what is known', () => {
    expect(refusalOf(() => attribute('views', 'scene vredict'))).toMatch(/“vredict” is none of toolbar, verdict, /)
    expect(refusalOf(() => attribute('preset', 'cubes'))).toMatch(/“cubes” is none of looks-fine, cube, /)
    expect(refusalOf(() => attribute('theme', 'sepia'))).toMatch(/“sepia” is none of auto, light, dark\./)
    for (const text of ['', '1', '0 91', '0 0 0', 'x 1', '1e999 0', '0 0 1 2'])
      expect(refusalOf(() => attribute('camera', text))).toMatch(/^bad-attribute: .*azimuth and elevation/)
  })
})
