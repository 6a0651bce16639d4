/** Nanoseconds an element against sigma, on a logarithmic scale: a panel for each query and target. */
import type { Row } from './tables'

const PANEL = { width: 330, height: 230, left: 46, top: 34, right: 12, bottom: 34 }
const LOWEST = 10
const HIGHEST = 5000
const TICKS = [10, 30, 100, 300, 1000, 3000]
const METHODS = [
  { name: 'Roots', key: 'roots_ns', colour: '#8a8f96', dash: '2 3' },
  { name: 'Roots+B', key: 'roots_b_ns', colour: '#b2182b', dash: '6 3' },
  { name: 'Hexlens', key: 'hexlens_ns', colour: '#2166ac', dash: 'none' },
] as const

export function plot(rows: readonly Row[]): string {
  const width = 2 * PANEL.width
  const height = 2 * PANEL.height
  const panels = (['validity', 'minimum'] as const).flatMap((query, i) =>
    (['native', 'wasm'] as const).map((target, j) => {
      const own = rows.filter(row => row.query === query && row.target === target)
      const title = `${query === 'validity' ? 'Validity' : 'Boundary minimum'}, ${target === 'native' ? 'native' : 'WebAssembly'}`
      return `<g transform="translate(${j * PANEL.width} ${i * PANEL.height})">${panel(title, own)}</g>`
    }),
  )
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="system-ui, sans-serif" font-size="11">`,
    '<title>Nanoseconds an element against sigma: Roots, Roots+B and Hexlens</title>',
    `<rect width="${width}" height="${height}" fill="#fcfcfb"/>`,
    ...panels,
    '</svg>\n',
  ].join('\n')
}

const plotWidth = PANEL.width - PANEL.left - PANEL.right
const plotHeight = PANEL.height - PANEL.top - PANEL.bottom

function y(ns: number): number {
  return PANEL.top + plotHeight * (1 - Math.log(ns / LOWEST) / Math.log(HIGHEST / LOWEST))
}

function panel(title: string, rows: readonly Row[]): string {
  const greatest = Math.max(...rows.map(({ sigma }) => sigma))
  const x = (sigma: number) => PANEL.left + (plotWidth * sigma) / greatest
  const right = PANEL.width - PANEL.right
  const grid = TICKS.map(
    ns =>
      `<path d="M${PANEL.left} ${y(ns).toFixed(1)}H${right}" stroke="#e4e5e3"/><text x="${PANEL.left - 6}" y="${(y(ns) + 4).toFixed(1)}" text-anchor="end" fill="#6a6f76">${ns}</text>`,
  )
  const marks = [0, 0.5, 1, 1.5, 2].map(
    sigma =>
      `<text x="${x(sigma).toFixed(1)}" y="${PANEL.height - 18}" text-anchor="middle" fill="#6a6f76">${sigma}</text>`,
  )
  const lines = METHODS.map(({ name, key, colour, dash }, i) => {
    const points = rows.map(row => `${x(row.sigma).toFixed(1)},${y(row[key]).toFixed(1)}`).join(' ')
    const at = PANEL.left + 8 + 84 * i
    return (
      `<polyline points="${points}" fill="none" stroke="${colour}" stroke-width="2" stroke-dasharray="${dash}"/>` +
      `<path d="M${at} 24h18" stroke="${colour}" stroke-width="2" stroke-dasharray="${dash}"/><text x="${at + 23}" y="28" fill="#1c1e21">${name}</text>`
    )
  })
  return [
    `<text x="${PANEL.left}" y="12" fill="#1c1e21" font-weight="600">${title}</text>`,
    ...grid,
    ...marks,
    `<text x="${right}" y="${PANEL.height - 4}" text-anchor="end" fill="#6a6f76">sigma; ns an element</text>`,
    ...lines,
  ].join('')
}
