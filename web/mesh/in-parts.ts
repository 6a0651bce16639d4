const PART = 8192

/**
 * Calls for one part of so many after the other, all of them. Engines make fast code of a function that is called again, long before they make
 * it of one long loop.
 */
export function inParts(count: number, each: (from: number, to: number) => void): void {
  for (let from = 0; from < count; from += PART) each(from, Math.min(from + PART, count))
}
