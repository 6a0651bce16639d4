/**
 * `--html`: one document that needs nothing else, to read and to keep: of each file the sentence, the notes, how the relative minima
 * are distributed, and its worst cells, drawn and in numbers. It is XML, too.
 */
import type { Report } from '../core/report'
import { isWhollyAnswered } from '../mesh/check'
import { countSentences } from '../mesh/check-summary'
import { histogramOf } from '../mesh/histogram'
import type { MeshCheck } from '../mesh/mesh-check'
import { grouped, headlineOf } from '../mesh/mesh-headline'
import { formatJacdet, formatNumber, formatPoint } from '../model/decimal'
import { VERTEX_COUNT, vertexOf } from '../model/hexahedron'
import { flatFigure, flatFigureHatch } from '../scene/paint/flat-figure'
import { thumbnailText } from '../scene/paint/thumbnail'
import { checkNamesOfMeshes } from '../views/check-names'
import { entityTitle } from '../views/entity-name'
import { histogramMarkup } from './html-histogram'
import { STYLES } from './html-styles'
import { nameOf } from './invalid-cells'
import { markup } from './markup'
import type { FileResult, Output } from './output'

/** Cells that are drawn, of those that are listed. */
const DRAWN = 10

export interface HtmlOptions {
  readonly fileCount: number
  readonly minRelative: number | null
  readonly skipsDegenerate: boolean
}

export function htmlOutput(options: HtmlOptions): Output {
  const { fileCount } = options
  let isBegun = false
  return {
    lists: { acceptedBy: true },
    *file(result) {
      if (!isBegun) yield headOf(fileCount === 1 ? result.file : `${fileCount} meshes`)
      if (!isBegun && fileCount > 1) yield `<h1 class="headline">${fileCount} meshes</h1>\n`
      isBegun = true
      yield* fileMarkup(result, options)
    },
    *end() {
      yield FOOT
    },
  }
}

function headOf(title: string): string {
  return `<!DOCTYPE html>
<html lang="en" xmlns="http://www.w3.org/1999/xhtml">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width"/>
<title>${markup(title)}: checked by Hexlens</title>
<style>${STYLES}</style>
</head>
<body>
${flatFigureHatch}
<main>
`
}

const FOOT = `</main>
<footer>Written by Hexlens. Every verdict is exact, by the boundary of the hexahedron. jacdet is that of the map from [0,1]³; a relative minimum is its minimum over |volume|, at most 1.</footer>
</body>
</html>
`

function* fileMarkup(result: FileResult, options: HtmlOptions): Generator<string> {
  const level = options.fileCount === 1 ? 1 : 2
  const head = (name: string, sentence: string) =>
    `<section class="file">\n<p class="name">${markup(name)}</p>\n<h${level} class="headline">${markup(sentence)}</h${level}>\n`
  if ('error' in result) yield `${head(result.file, 'The file was not read.')}<p>${markup(result.error)}</p>\n`
  else {
    const { file, check } = result
    const headline = headlineOf(check)
    yield head(`${file} (${check.mesh.format})`, headline === '' ? 'There are no hexahedra of eight nodes.' : headline)
    yield notesMarkup(check, options)
    yield histogramMarkup(histogramOf(check), level + 1)
    yield* worstMarkup(check, level + 1)
  }
  yield '</section>\n'
}

function notesMarkup(check: MeshCheck, { minRelative, skipsDegenerate }: HtmlOptions): string {
  const { below, hexahedra, invalid, notes } = check
  const sentences = [
    ...(minRelative === null ? [] : [`${grouped(below)} with a relative minimum below ${minRelative}.`]),
    ...countSentences(check, { skipsDegenerate }),
    ...notes,
    ...(hexahedra > 0 && invalid === 0 && !isWhollyAnswered(check) ? ['Not all could be answered.'] : []),
  ]
  if (sentences.length === 0) return ''
  return `<ul class="notes">\n${sentences.map(sentence => `<li>${markup(sentence)}</li>\n`).join('')}</ul>\n`
}

function* worstMarkup(check: MeshCheck, level: number): Generator<string> {
  const cells = check.worst.subarray(0, DRAWN)
  if (cells.length === 0) return
  const title = cells.length === 1 ? 'The worst cell' : `The worst ${cells.length} cells, worst first`
  yield `<h${level} class="part">${title}</h${level}>\n<div class="cells">\n`
  for (const cell of cells) yield cellMarkup(check, cell, level + 1)
  yield '</div>\n'
}

function cellMarkup(check: MeshCheck, cell: number, level: number): string {
  const block = check.blockOf(cell)
  const name = `${check.mesh.ids === null ? 'Index' : 'Cell'} ${nameOf(check, cell)}${block === null ? '' : `, block ${block}`}`
  const answer = check.answerTo(cell)
  const body = 'why' in answer ? `<p class="why">Unanswered. ${markup(answer.why)}</p>` : reportMarkup(answer.report)
  return `<section class="cell">\n<h${level}>${markup(name)}</h${level}>\n${body}\n</section>\n`
}

function reportMarkup(report: Report): string {
  const rows = rowsOf(report).map(([term, text]) => `<dt>${term}</dt><dd>${text}</dd>`)
  const points = Array.from({ length: VERTEX_COUNT }, (_, v) => vertexOf(report.vertices, v))
  const vertices = points.map((point, v) => `<tr><th>${v}</th>${point.map(x => `<td>${x}</td>`).join('')}</tr>`)
  return `${flatFigure(report, markup(thumbnailText(report)))}
<dl>${rows.join('')}</dl>
<details><summary>Its vertices</summary><table>${vertices.join('')}</table></details>`
}

function rowsOf(report: Report): [term: string, markup: string][] {
  const { valid, relativeMinimum, boundaryMinimum, exponent, minimizer, volume, volumeExponent, checks } = report
  const relative = relativeMinimum === null ? 'none, the volume is 0' : formatNumber(relativeMinimum)
  const accepting = checks.filter(({ passes }) => passes).map(({ id }) => checkNamesOfMeshes[id])
  const accepted =
    accepting.length === 0 ? 'none' : accepting.length === checks.length ? 'all checks' : accepting.join(', ')
  const title = entityTitle(minimizer)
  const point = minimizer.kind === 'vertex' ? '' : `, (ξ, η, ζ) = ${formatPoint(minimizer.point)}`
  const place = `${title.charAt(0).toLowerCase()}${title.slice(1)}${point}`
  const sign = (text: string) => (valid ? text : `<b class="negative">${text}</b>`)
  return [
    ['Relative minimum', sign(relative)],
    ['Minimum', `${sign(formatJacdet(boundaryMinimum, exponent, 'unit'))} at ${place}`],
    ['Volume', formatJacdet(volume, volumeExponent, 'unit')],
    ['Class', `${sign(report.class)}${report.shape === null ? '' : `, ${report.shape}`}`],
    ['Accepted by', accepted],
  ]
}
