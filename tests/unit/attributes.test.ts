import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { readAttribute, readVertices, verticesText } from '../../web/element/attributes'
import { HexLensError } from '../../web/element/hex-lens-error'
import { unitCube } from './core-fixtures'

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
    expect(readAttribute('views', null)).toEqual(['scene', 'verdict'])
    expect(readAttribute('controls', null)).toEqual(['faces', 'reference', 'turn', 'fit', 'help'])
    expect(readAttribute('theme', null)).toBe('auto')
    expect([readAttribute('readonly', null), readAttribute('readonly', '')]).toEqual([false, true])
    for (const name of ['vertices', 'preset', 'camera', 'poster', 'label'] as const)
      expect(readAttribute(name, null)).toBeNull()
  })

  it('list words, all or none', () => {
    expect(readAttribute('views', ' verdict,scene ')).toEqual(['verdict', 'scene'])
    expect(readAttribute('views', 'all')).toContain('take-away')
    expect(readAttribute('controls', 'none')).toEqual([])
    expect(readAttribute('preset', 'cube')?.id).toBe('cube')
  })

  it('say from where to look: azimuth, elevation and zoom', () => {
    expect(readAttribute('camera', '0 0')).toEqual({ direction: [1, 0, 0], zoom: 1, pan: [0, 0, 0] })
    const view = readAttribute('camera', '90deg, 45deg, 2.5')
    expect(view?.zoom).toBe(2.5)
    expect(view?.direction[1]).toBeCloseTo(Math.SQRT1_2, 15)
    expect(view?.direction[2]).toBeCloseTo(Math.SQRT1_2, 15)
  })

  it('are refused with a sentence that says what is known', () => {
    expect(refusalOf(() => readAttribute('views', 'scene vredict'))).toMatch(/“vredict” is none of toolbar, verdict, /)
    expect(refusalOf(() => readAttribute('preset', 'cubes'))).toMatch(/“cubes” is none of looks-fine, cube, /)
    expect(refusalOf(() => readAttribute('theme', 'sepia'))).toMatch(/“sepia” is none of auto, light, dark\./)
    for (const text of ['', '1', '0 91', '0 0 0', 'x 1', '1e999 0', '0 0 1 2'])
      expect(refusalOf(() => readAttribute('camera', text))).toMatch(/^bad-attribute: .*azimuth and elevation/)
  })
})
