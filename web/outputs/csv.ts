/** `--csv`: one line for each hexahedron, in the file's order; RFC 4180. What there is not is empty. */
import { CHECKS, CLASSES } from '../core/unpack'
import type { MeshCheck } from '../mesh/mesh-check'
import { jsonNumber } from './json-number'
import { type Output, withoutControls } from './output'

const COLUMNS = [
  'file',
  'index',
  'id',
  'block',
  'valid',
  'class',
  'boundary_min',
  'relative_min',
  'volume',
  'xi',
  'eta',
  'zeta',
  'decided_by',
  'accepted_by',
]

export function csvOutput(): Output {
  let isBegun = false
  return {
    lists: { minima: true, volumes: true, acceptedBy: true, exact: true },
    *file(result) {
      if (!isBegun) yield line(COLUMNS)
      isBegun = true
      if ('error' in result) return
      for (let cell = 0; cell < result.check.hexahedra; ++cell) yield line(row(result.file, result.check, cell))
    },
    *end() {
      if (!isBegun) yield line(COLUMNS)
    },
  }
}

function row(file: string, check: MeshCheck, cell: number): (string | number)[] {
  const { minima, volumes, acceptedBy, exact, classes, valid, relativeMinima } = check.answers
  const name = [file, cell, check.idOf(cell) ?? '', check.blockOf(cell) ?? '']
  if (!check.isAnswered(cell) || !minima || !volumes || !acceptedBy || !exact)
    return [...name, ...COLUMNS.slice(4).map(() => '')]
  const relative = relativeMinima[cell] as number
  return [
    ...name,
    valid[cell] === 1 ? 'true' : 'false',
    CLASSES[classes[cell] as number] ?? '',
    jsonNumber(minima.values[cell] as number, minima.exponents[cell] as number),
    Number.isNaN(relative) ? '' : relative,
    jsonNumber(volumes.values[cell] as number, volumes.exponents[cell] as number),
    ...minima.minimizers.subarray(3 * cell, 3 * cell + 3),
    exact[cell] === 1 ? 'exact' : 'filter',
    CHECKS.filter((_, c) => ((acceptedBy[cell] as number) >> c) & 1).join(' '),
  ]
}

function line(fields: readonly (string | number)[]): string {
  return `${fields.map(field).join(',')}\r\n`
}

function field(value: string | number): string {
  if (typeof value === 'number') return String(value)
  const text = withoutControls(value)
  return /[",]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
