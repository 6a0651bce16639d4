/** The six faces as maps of jacdet, the bound of each, and the quartic of the selected one. */

import { html, render } from 'lit-html'
import { type FacePolynomials, facePolynomials, leastInRow } from '../../core/face-polynomials'
import type { FaceReport, Report } from '../../core/report'
import { type FaceTopology, faces, type Vec3 } from '../../model/hexahedron'
import { sliceChange, sliceOf } from '../../model/state'
import { isNew } from '../../views/is-new'
import { marksSlice } from '../../views/scene-slices'
import type { CreateView, Figure, FigureName, Frame, Update, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import { boundsTable } from './bounds-table'
import css from './face-maps.css?inline'
import { FaceNet } from './face-net'
import { formulas } from './formulas'
import { facePoint, isOnFace } from './net'
import { OwnProbe } from './own-probe'
import { Plots } from './plots'
import { quarticWords } from './quartic'
import { faceSlice } from './selected-face'

export const styles = css

class FaceMapsView implements View {
  readonly root = document.createElement('div')
  readonly updates: readonly Update[]
  readonly #context: ViewContext
  readonly #probe: OwnProbe
  readonly #net: FaceNet
  readonly #table = document.createElement('div')
  readonly #words = document.createElement('div')
  readonly #formulas = document.createElement('div')
  readonly #plots = new Plots(t => this.#probeRow(t))
  readonly #resizes: ResizeObserver
  #width = 0
  #report: Report | null = null
  #polynomials: { readonly face: FaceReport; readonly of: FacePolynomials } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.#probe = new OwnProbe(context)
    this.#net = new FaceNet(context, this.#probe, 'face-map-keys')
    const draws: FaceNet['updates'] = [
      ...this.#net.updates,
      (frame, report) => this.#drawWords(frame, report),
      (frame, report) => this.#drawFormulas(frame, report),
      (frame, report) => this.#drawPlots(frame, report),
    ]
    this.updates = draws.map(draw => (frame: Frame) => {
      if (frame.report !== null) draw(frame, frame.report)
    })
    this.root.className = 'face-maps'
    const keys = html`<span id="face-map-keys" class="said">${say('Arrow keys move the point over this face. Escape removes it. Enter shows the face’s quartic.')}</span>`
    render([this.#net.root, keys, this.#table, this.#words, this.#plots.root, this.#formulas], this.root)
    this.#resizes = new ResizeObserver(entries => {
      this.#width = Math.floor(entries.at(-1)?.contentRect.width ?? 0)
      context.requestFrame()
    })
    this.#resizes.observe(this.root)
  }

  update({ state, report }: Frame): void {
    const isRead = report !== null && state.openPanels.includes('face-maps')
    this.#drawCurveOn(isRead ? sliceOf(faceSlice, state).selectedFace : null)
    this.root.hidden = report === null
    this.#report = report
    if (report !== null) this.#net.layOut(this.#width, report)
  }

  figure(name: FigureName): Figure | null {
    return name === 'face-maps' && this.#report !== null ? this.#net.figure() : null
  }

  dispose(): void {
    this.#resizes.disconnect()
    this.#drawCurveOn(null)
    this.#net.dispose()
  }

  /** In the scene. */
  #drawCurveOn(face: number | null): void {
    if (face !== sliceOf(marksSlice, this.#context.state()).curveOn)
      this.#context.dispatch(sliceChange(marksSlice, { curveOn: face }))
  }

  /** Probes the point at which the face's row t has its least value. */
  #probeRow(t: number | null): void {
    const { selectedFace } = sliceOf(faceSlice, this.#context.state())
    const face = this.#report?.faces[selectedFace]
    this.#net.pointedFace = selectedFace
    const point = t === null || !face ? null : facePoint(selectedFace, leastInRow(this.#polynomialsOf(face), t), t)
    this.#probe.set('plots', point)
  }

  #polynomialsOf(face: FaceReport): FacePolynomials {
    if (this.#polynomials?.face !== face) this.#polynomials = { face, of: facePolynomials(face.bernstein) }
    return this.#polynomials.of
  }

  #drawWords({ state }: Frame, report: Report): void {
    const { referenceCube } = state
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#words, report, referenceCube, selectedFace)) return
    render(boundsTable(report, referenceCube, selectedFace), this.#table)
    render(quarticWords(report, report.faces[selectedFace] as FaceReport, referenceCube), this.#words)
  }

  #drawFormulas({ state }: Frame, report: Report): void {
    const { referenceCube } = state
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#formulas, report, referenceCube, selectedFace)) return
    const face = report.faces[selectedFace] as FaceReport
    render(formulas(face, this.#polynomialsOf(face), report.exponent, referenceCube), this.#formulas)
  }

  #drawPlots({ state }: Frame, report: Report): void {
    const face = report.faces[sliceOf(faceSlice, state).selectedFace] as FaceReport
    const onFace = state.probe !== null && isOnFace(face.id, state.probe)
    const t = onFace ? (state.probe as Vec3)[(faces[face.id] as FaceTopology).t] : null
    const { name } = faces[face.id] as FaceTopology
    const picture = { name, face, exponent: report.exponent, cube: state.referenceCube }
    this.#plots.update({ ...picture, polynomials: this.#polynomialsOf(face) }, t)
  }
}

export const create: CreateView = context => new FaceMapsView(context)
