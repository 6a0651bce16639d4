/** The whole report as JSON, with the element's name and the version that computed it. */
import type { Report } from './report'

/** Numbers as the report has them: every jacdet is its number times 2^exponent. -0 keeps its sign, as JSON allows. */
export function reportJson(report: Report, name: string, version: string): string {
  return `${jsonText({ name, version, hexlens: 'report', ...report, vertices: rowsOf(report.vertices) }, '')}\n`
}

function rowsOf(vertices: readonly number[]): number[][] {
  return Array.from({ length: vertices.length / 3 }, (_, v) => vertices.slice(3 * v, 3 * v + 3))
}

/** JSON.stringify with two spaces, but with lists of numbers on one line, and -0 as it is. */
function jsonText(value: unknown, indent: string): string {
  if (typeof value === 'number') return Object.is(value, -0) ? '-0' : JSON.stringify(value)
  if (typeof value !== 'object' || value === null) return JSON.stringify(value)
  const inner = `${indent}  `
  if (Array.isArray(value)) {
    if (value.every(entry => typeof entry === 'number'))
      return `[${value.map(entry => jsonText(entry, '')).join(', ')}]`
    return `[\n${value.map(entry => inner + jsonText(entry, inner)).join(',\n')}\n${indent}]`
  }
  const fields = Object.entries(value).map(
    ([key, entry]) => `${inner}${JSON.stringify(key)}: ${jsonText(entry, inner)}`,
  )
  return `{\n${fields.join(',\n')}\n${indent}}`
}
