/** A coordinate and the text of its field. */

/** The shortest text that reads back as the same double, the sign of zero included. */
export function coordinateText(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value)
}

/** The number in a field's text, or null if it is not a finite number. */
export function readCoordinate(text: string): number | null {
  const value = text.trim() === '' ? Number.NaN : Number(text)
  return Number.isFinite(value) ? value : null
}

/**
 * The text as a number field can take it whole, or null. A browser drops what is not of a number
 * without a word, and "0,25" would be 25. A comma typed by itself means the decimal point; true
 * minus signs are how this page writes them.
 */
export function fieldText(text: string): string | null {
  const plain = text === ',' ? '.' : text.trim().replaceAll('−', '-')
  return plain !== '' && /^[-+.\deE]+$/.test(plain) ? plain : null
}
