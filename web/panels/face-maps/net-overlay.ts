/**
 * The SVG over the net: borders and names of faces, vertex numbers, the candidates, the minimizer,
 * the probe. The candidates are one stop of the Tab key; arrow keys go from one to the next.
 */
import type { Candidate, Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import { faces, type Vec3, vertexReference } from '../../model/hexahedron'
import { type ReferenceCube, type State, sliceOf } from '../../model/state'
import { candidateShapes } from '../../scene/overlay/candidate-shapes'
import { px, set, show, svg } from '../../scene/paint/svg'
import { entityTitle } from '../../views/entity-name'
import { isForeign } from '../../views/point-steps'
import { type Entity, type SpokenPoint, spokenOf } from '../../views/scene-slices'
import { say } from '../../words/say'
import { edgePlaces, isOnFace, netCells, netCorners, type Place, placeOnFace, placesOf } from './net'
import { faceSlice } from './selected-face'

export interface NetPicture {
  readonly state: State
  readonly report: Report
  /** CSS pixels a side. */
  readonly cell: number
}

interface Mark {
  readonly group: SVGGElement
  readonly path: SVGPathElement
}

const NUMBER_DISTANCE = 9
const RING = 7.5

export class NetOverlay {
  readonly root = svg('svg', { class: 'face-overlay lettered' })
  readonly #cells = netCells.map(() => svg('rect', { class: 'cell' }))
  readonly #selected = svg('rect', { class: 'selected' })
  readonly #names = faces.map(({ name }) => svg('text', { class: 'name' }, name))
  readonly #numbers = netCorners.map(({ vertex }) => svg('text', { class: 'number' }, String(vertex)))
  readonly #highlight = svg('path', { class: 'highlight' })
  readonly #crossHalo = svg('path', { class: 'cross-halo' })
  readonly #cross = svg('path', { class: 'cross' })
  readonly #rings = svg('g', { class: 'rings' })
  readonly #candidates = svg('g', { role: 'group', 'aria-label': say('Candidates for the minimum') })
  readonly #marks: Mark[] = []
  readonly #probe: (candidate: Candidate | null) => void
  #isProbing = false
  #listed: readonly Candidate[] = []
  /** The one that Tab reaches. */
  #current = 0
  #cell = 0
  #labelled: readonly unknown[] = []

  constructor(probe: (candidate: Candidate | null) => void) {
    this.#probe = probe
    const decoration = svg('g', { 'aria-hidden': 'true' })
    decoration.append(...this.#cells, this.#highlight, this.#selected, this.#crossHalo, this.#cross)
    decoration.append(...this.#names, ...this.#numbers)
    const rings = svg('g', { 'aria-hidden': 'true' }, this.#rings)
    this.root.append(decoration, this.#candidates, rings)
    this.#candidates.addEventListener('keydown', event => this.#onKey(event))
    this.#candidates.addEventListener('focusin', event => this.#onFocus(event))
    this.#candidates.addEventListener('focusout', () => this.#probeAt(null))
  }

  update({ state, report, cell }: NetPicture): void {
    if (cell !== this.#cell) this.#layOut(cell)
    const { column, row } = netCells[sliceOf(faceSlice, state).selectedFace] as (typeof netCells)[number]
    set(this.#selected, { x: px(column * cell), y: px(row * cell) })
    this.#updateCandidates(report)
    this.#updateLabels(state, report)
    this.#updateRings(report)
    this.#updateCross(state)
    const path = spokenOf(state).map(spoken => this.#highlightPath(spoken))
    set(this.#highlight, { d: path.join('') })
    show(this.#highlight, path.length > 0)
  }

  #layOut(cell: number): void {
    this.#cell = cell
    const [width, height] = [4 * cell, 3 * cell]
    set(this.root, { viewBox: `0 0 ${width} ${height}`, width, height })
    netCells.forEach(({ column, row }, face) => {
      const [x, y] = [column * cell, row * cell]
      set(this.#cells[face] as SVGRectElement, { x, y, width: cell, height: cell })
      set(this.#names[face] as SVGTextElement, { x: x + 8, y: y + 13 })
    })
    set(this.#selected, { width: cell, height: cell })
    netCorners.forEach(({ x, y, towards }, i) => {
      set(this.#numbers[i] as SVGTextElement, {
        x: px(x * cell + towards.x * NUMBER_DISTANCE),
        y: px(y * cell + towards.y * NUMBER_DISTANCE),
      })
    })
  }

  #updateCandidates(report: Report): void {
    this.#listed = report.candidates
    this.#current = Math.min(this.#current, this.#listed.length - 1)
    let used = 0
    for (const [index, { kind, point }] of this.#listed.entries()) {
      for (const [i, place] of placesOf(point).entries()) {
        const { group, path } = this.#mark(used++)
        group.setAttribute('transform', this.#translate(place))
        set(path, { d: candidateShapes[kind] })
        if (i > 0) this.#hideFromReaders(group)
        else group.dataset.candidate = String(index)
        show(group, true)
      }
    }
    for (const { group } of this.#marks.slice(used)) {
      show(group, false)
      this.#hideFromReaders(group)
    }
    this.#updateTabStop()
  }

  #mark(i: number): Mark {
    const known = this.#marks[i]
    if (known) return known
    const path = svg('path', { class: 'candidate' })
    const mark = { group: svg('g', { class: 'mark' }, path), path }
    this.#marks.push(mark)
    this.#candidates.append(mark.group)
    return mark
  }

  #hideFromReaders(group: SVGGElement): void {
    if (group.hasAttribute('aria-hidden')) return
    delete group.dataset.candidate
    for (const name of ['role', 'tabindex', 'aria-label']) group.removeAttribute(name)
    group.setAttribute('aria-hidden', 'true')
  }

  #updateTabStop(): void {
    for (const { group } of this.#marks) {
      const { candidate } = group.dataset
      if (candidate === undefined) continue
      group.removeAttribute('aria-hidden')
      group.setAttribute('role', 'img')
      group.setAttribute('tabindex', Number(candidate) === this.#current ? '0' : '-1')
    }
  }

  /** Labels wait until a drag ends: nobody can ask for them meanwhile. */
  #updateLabels({ gestureStart, referenceCube }: State, report: Report): void {
    if (gestureStart !== null && this.#labelled.length > 0) return
    if (this.#labelled[0] === report && this.#labelled[1] === referenceCube) return
    this.#labelled = [report, referenceCube]
    for (const { group } of this.#marks) {
      const candidate = this.#listed[Number(group.dataset.candidate)]
      if (candidate) group.setAttribute('aria-label', candidateText(candidate, report, referenceCube))
    }
  }

  #updateRings({ minimizer }: Report): void {
    const places = placesOf(minimizer.point)
    while (this.#rings.childElementCount < places.length) {
      const circles = ['rim', 'ring'].map(name => svg('circle', { class: name, r: RING }))
      this.#rings.append(svg('g', {}, ...circles))
    }
    this.#rings.classList.toggle('positive', minimizer.value > 0)
    for (const [i, group] of [...this.#rings.children].entries()) {
      const place = places[i]
      show(group, place !== undefined)
      if (place) group.setAttribute('transform', this.#translate(place))
    }
  }

  /** Hair lines across every cell that has the point, open in the middle. */
  #updateCross({ probe }: State): void {
    const cell = this.#cell
    let path = ''
    for (const [face, { column, row }] of netCells.entries()) {
      if (probe === null || !isOnFace(face, probe)) continue
      const { x, y } = placeOnFace(face, probe)
      const [left, top, at, down] = [column * cell, row * cell, x * cell, y * cell].map(px)
      path += `M${left} ${down}h${px(cell)}M${at} ${top}v${px(cell)}`
    }
    for (const line of [this.#crossHalo, this.#cross]) {
      set(line, { d: path })
      show(line, path !== '')
    }
  }

  #highlightPath(spoken: Entity | SpokenPoint): string {
    const cell = this.#cell
    const at = ({ x, y }: Place) => `${px(x * cell)} ${px(y * cell)}`
    const ring = (place: Place) => `M${at(place)}m-7 0a7 7 0 1 0 14 0a7 7 0 1 0 -14 0`
    if (spoken.kind === 'point') return placesOf(spoken.point).map(ring).join('')
    const { kind, id } = spoken
    if (kind === 'edge')
      return edgePlaces(id)
        .map(([from, to]) => `M${at(from)}L${at(to)}`)
        .join('')
    if (kind === 'face') {
      const { column, row } = netCells[id] as (typeof netCells)[number]
      return `M${at({ x: column, y: row })}h${px(cell)}v${px(cell)}h${px(-cell)}Z`
    }
    return placesOf(vertexReference[id] as Vec3)
      .map(ring)
      .join('')
  }

  #translate({ x, y }: Place): string {
    return `translate(${px(x * this.#cell)} ${px(y * this.#cell)})`
  }

  #onFocus({ target }: FocusEvent): void {
    const index = Number((target as SVGGElement).dataset.candidate)
    this.#current = index
    this.#updateTabStop()
    this.#probeAt(this.#listed[index] ?? null)
  }

  #probeAt(candidate: Candidate | null): void {
    this.#isProbing = candidate !== null
    this.#probe(candidate)
  }

  #onKey(event: KeyboardEvent): void {
    const last = this.#listed.length - 1
    const next = {
      ArrowRight: Math.min(this.#current + 1, last),
      ArrowDown: Math.min(this.#current + 1, last),
      ArrowLeft: Math.max(this.#current - 1, 0),
      ArrowUp: Math.max(this.#current - 1, 0),
      Home: 0,
      End: last,
    }[event.key]
    if (isForeign(event)) return
    if (event.key === 'Escape' && this.#isProbing) this.#probeAt(null)
    else if (next !== undefined) {
      this.#marks.find(({ group }) => group.dataset.candidate === String(next))?.group.focus({ preventScroll: true })
    } else return
    event.preventDefault()
  }
}

export function candidateText(candidate: Candidate, report: Report, cube: ReferenceCube): string {
  const value = formatJacdet(candidate.value, report.exponent, cube)
  const isLeast = candidate.point === report.minimizer.point || samePoint(candidate, report.minimizer)
  const entity = entityTitle(candidate)
  return isLeast ? say('{entity}: J = {value}, the minimum', { entity, value }) : `${entity}: J = ${value}`
}

function samePoint(a: Candidate, b: Candidate): boolean {
  return a.point.every((value, axis) => value === b.point[axis])
}
