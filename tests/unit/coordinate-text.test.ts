import { describe, expect, it } from 'vitest'
import { coordinateText, fieldText, readCoordinate } from '../../web/panels/vertices/coordinate-text'

describe('a coordinate as text', () => {
  it('is the shortest that reads back as the same double', () => {
    for (const value of [0, -0, 1, -1.5, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, 1e21, 1e-7, 2 ** 53 + 2]) {
      expect(readCoordinate(coordinateText(value)), coordinateText(value)).toBe(value)
    }
    expect(coordinateText(-0)).toBe('-0')
    expect(coordinateText(0.1 + 0.2)).toBe('0.30000000000000004')
  })

  it('is refused unless it is a finite number', () => {
    for (const text of ['', ' ', '1e', '-', '1e999', '-1e999', 'NaN', 'Infinity', '1,5']) {
      expect(readCoordinate(text), text).toBeNull()
    }
  })
})

describe('a text for a number field', () => {
  it('is taken with true minus signs and a comma typed as the decimal point', () => {
    for (const [text, taken] of [
      ['1.5e-3', '1.5e-3'],
      [' −2.5\n', '-2.5'],
      [',', '.'],
      ['7', '7'],
    ] as const) {
      expect(fieldText(text), text).toBe(taken)
    }
  })

  it('is refused where the field would drop a part of it', () => {
    for (const text of ['0,25', '1,000.5', '1/3', '0.1 0.2', '[[0,0,0]]', 'x', ' ', '']) {
      expect(fieldText(text), text).toBeNull()
    }
  })
})
