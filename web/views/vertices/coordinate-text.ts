/** A coordinate and the text of its field. */

/** The shortest text that reads back as the same double, the sign of zero included. */
export function coordinateText(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value)
}

/** What a field's text says, or null where it is not a finite number. */
export function readCoordinate(text: string): number | null {
  const value = text.trim() === '' ? Number.NaN : Number(text)
  return Number.isFinite(value) ? value : null
}
