/**
 * Points among other words and numbers, as solvers and meshers log them: "node 17 (1.0, 2.0, 3.0)", "x= 1 y= 2 z= 3",
 * "17 1.0 2.0 3.0". Points of one element look alike: lines that differ in their numbers alone belong together.
 */
import type { Vec3 } from '../hexahedron'
import { type Format, type FoundElement, readingOf } from './format'
import { numberPattern, toDouble } from './numbers'
import { Scanner } from './scanner'

const DATES_AND_TIMES = /\b\d{4}-\d\d-\d\d\b|\b\d\d?:\d\d(?::\d\d(?:\.\d+)?)?\b/g
const LABELLED =
  /(?<![A-Za-z])x\d*\s*[=:]\s*([^\s,;]{1,40})[\s,;]+y\d*\s*[=:]\s*([^\s,;]{1,40})[\s,;]+z\d*\s*[=:]\s*([^\s,;)\]}]{1,40})/gi
const ELEMENT = /\b(?:element|elem|cell|hexahedron|hexahedra|hex|brick)s?\b[\s#:=.(no]*(\d+)/i
const BETWEEN = /^(?:[\s,;|]+|)$/
const INTEGER = /^[-+]?\d+$/

export const pointsInText: Format = {
  name: 'points in other text',
  read(text) {
    const points = pointsOf(text)
    const groups = groupedByLikeness(points).filter(group => group.length % 8 === 0)
    const chosen = groups.length > 0 ? groups : points.length % 8 === 0 ? [points] : []
    const elements = chosen.flatMap(inEights)
    return elements.length > 0 ? readingOf(elements) : null
  },
}

interface FoundPoint {
  readonly at: Vec3
  /** The same for points that are written alike. */
  readonly likeness: string
  readonly element: string | null
}

/** How many points a text has, for the sentence that says what was seen. */
export function countPoints(text: string): number {
  return pointsOf(text).length
}

function groupedByLikeness(points: readonly FoundPoint[]): FoundPoint[][] {
  const groups = new Map<string, FoundPoint[]>()
  for (const point of points) {
    const group = groups.get(point.likeness)
    if (group) group.push(point)
    else groups.set(point.likeness, [point])
  }
  return [...groups.values()]
}

function pointsOf(text: string): FoundPoint[] {
  const points: FoundPoint[] = []
  const lines = new Scanner(text)
  let element: string | null = null
  for (let line = lines.line(); line !== null; line = lines.line()) {
    const bare = line.replace(DATES_AND_TIMES, '@')
    const number = ELEMENT.exec(bare)?.[1]
    if (number !== undefined) element = `element ${number}`
    const found = pointsOnLine(bare)
    if (found.length === 0) continue
    const skeleton = bare.replace(numberPattern(), '#').replace(/\s+/g, ' ')
    found.forEach((at, i) => {
      points.push({ at, likeness: found.length % 8 === 0 ? skeleton : `${i} ${skeleton}`, element })
    })
  }
  return points
}

function pointsOnLine(line: string): Vec3[] {
  const labelled = Array.from(line.matchAll(LABELLED), match => match.slice(1, 4))
  if (labelled.length > 0) return labelled.map(texts => texts.map(toDouble) as unknown as Vec3)
  return runsOfNumbers(line).flatMap(run => {
    const isPoint = run.length === 3 || (run.length === 4 && INTEGER.test(run[0] as string))
    return isPoint ? [run.slice(-3).map(toDouble) as unknown as Vec3] : []
  })
}

/** Numbers with nothing but separators between them. */
function runsOfNumbers(line: string): string[][] {
  const runs: string[][] = []
  let end = -1
  for (const match of line.matchAll(numberPattern())) {
    if (end >= 0 && BETWEEN.test(line.slice(end, match.index))) runs.at(-1)?.push(match[0])
    else runs.push([match[0]])
    end = match.index + match[0].length
  }
  return runs
}

function inEights(points: readonly FoundPoint[]): FoundElement[] {
  return Array.from({ length: points.length / 8 }, (_, i) => {
    const eight = points.slice(8 * i, 8 * i + 8)
    return {
      name: eight[0]?.element ?? `points ${8 * i + 1} to ${8 * i + 8}`,
      vertices: eight.flatMap(({ at }) => at),
    }
  })
}
