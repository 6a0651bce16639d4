/**
 * The element in physical space, and the reference cube: faces coloured by jacdet in WebGL, and over them, in SVG, edges, handles,
 * marks and words. It draws a frame and emits actions; one picture per update and none in between.
 *
 * Dragged coordinates are rounded to the power of ten at or below one pixel's length. Keys: see help.ts; the digit on a
 * handle chooses that handle.
 */
import { lowerInside } from '../core/inside'
import { pointOfValue } from '../core/point-of-value'
import type { Vec3 } from '../model/hexahedron'
import { type Cameras, type CameraView, type State, sliceChange, sliceOf } from '../model/state'
import { placeMarksOf } from '../views/place-marks'
import { controlsSlice, helpToggled, type SceneState, sceneSlice } from '../views/scene-slices'
import type { Figure, FigureName, Frame, Update, View, ViewContext } from '../views/view'
import { ElementPane } from './element-pane'
import { Controls } from './input/controls'
import { nextCandidate } from './input/probe-input'
import { ColourBar } from './overlay/colour-bar'
import { Help } from './overlay/help'
import { SpokenProbe } from './overlay/readout'
import { faceContext } from './paint/face-painter'
import { figureOf } from './paint/figure'
import { Painting, scaleOf } from './paint/painting'
import type { PaneScene } from './pane'
import { ReferenceCube } from './reference-cube'
import styles from './scene.css?inline'
import { Layout } from './space/layout'
import { LinkedCameras, type OrbitCamera } from './space/orbit-camera'

/** Everything in a figure: neither the controls, nor marks for the pointer. */
const IN_FIGURE = 'canvas, .scene-flat, .scene-overlay, .scene-scale > button, .scene-scale svg'

class Scene implements View, PaneScene {
  readonly root = document.createElement('div')
  readonly updates: readonly Update[] = [frame => this.#drawColourBar(frame)]
  readonly host: ViewContext
  readonly #painting: Painting
  readonly #help = new Help('scene-help')
  readonly #pane: ElementPane
  readonly #layout: Layout
  readonly #cameras: LinkedCameras
  readonly #colourBar: ColourBar
  readonly #controls: Controls
  readonly #spokenProbe = new SpokenProbe()
  readonly #resizes = new ResizeObserver(() => this.#onResize())
  /** Made when it is first shown. */
  #reference: ReferenceCube | null = null
  /** True if the browser has laid out the scene once: asking for that in the frame that adds it to the page is slow. */
  #isLaidOut = false
  #sizeMayDiffer = true
  #shown: Frame | null = null
  /** The cameras that a program last asked for. */
  #asked: Cameras | null = null

  constructor(host: ViewContext) {
    this.host = host
    this.root.className = 'scene'
    this.#painting = new Painting(this.root, host)
    this.#pane = new ElementPane(this, this.#help.root.id)
    this.#layout = new Layout(this.root, this.#pane.root)
    this.#cameras = new LinkedCameras(this.#pane.orbit, () => host.state())
    this.#colourBar = new ColourBar(
      referenceCube => host.dispatch({ type: 'show-reference-cube', referenceCube }),
      value => this.#probeValue(value),
    )
    this.#controls = new Controls({
      fit: () => this.#pane.fit(false),
      toggleHelp: () => host.dispatch(helpToggled(host.state())),
      toggleReference: () => this.toggleReference(),
      turn: (right, up) => this.#pane.turn(right, up),
      zoom: factor => this.#pane.zoom(factor),
      hold: held => host.dispatch(sliceChange(controlsSlice, { held })),
      showMinimum: () => this.showMinimum(),
      showFaces: faceDisplay => host.dispatch(sliceChange(sceneSlice, { faceDisplay })),
    })
    for (const { root } of [this.#colourBar, this.#help, this.#controls, this.#spokenProbe])
      this.#pane.root.append(root)
    this.root.append(this.#painting.root, this.#pane.root)
    const onPointer = ({ pointerType }: PointerEvent) =>
      host.dispatch(sliceChange(controlsSlice, { byFinger: pointerType !== 'mouse' }))
    this.root.addEventListener('pointerdown', onPointer, { capture: true })
    this.#resizes.observe(this.root)
  }

  get isLoading(): boolean {
    return this.#painting.isLoading
  }

  update(frame: Frame): void {
    const { state, isForPaper } = frame
    if (!this.#isLaidOut && !isForPaper) {
      this.#layOut()
      return
    }
    this.root.style.visibility = ''
    this.#pane.name(state)
    const before = this.#shown?.state ?? null
    const changesMedium = isForPaper !== (this.#shown?.isForPaper ?? false)
    this.#sizeMayDiffer ||= changesMedium
    const resized = this.#resize(state)
    if (this.#layout.isEmpty) return
    this.#painting.readTheme()
    this.#pane.aim(frame, changesMedium, { before, resized })
    this.#look(frame)
    this.#cameras.join(state, before)
    this.#pane.inputs.probe.update()
    this.#draw(frame)
    this.#spokenProbe.update(frame)
    this.#shown = frame
  }

  dispose(): void {
    this.#resizes.disconnect()
    this.#pane.dispose()
    this.#reference?.dispose()
    this.#painting.dispose()
  }

  figure(name: FigureName): Figure | null {
    if (name !== 'scene' || this.#shown === null) return null
    this.#draw(this.#shown, true)
    this.host.requestFrame()
    return figureOf(this.root, this.root.querySelectorAll(IN_FIGURE))
  }

  cameras(): Cameras | null {
    if (this.#shown === null || this.host.state().cameras !== this.#asked) return null
    return {
      camera: this.#pane.fitting.cameraView(this.#shown.state.vertices),
      referenceCamera: this.#reference ? this.#reference.cameraView() : (this.#asked?.referenceCamera ?? null),
    }
  }

  onTurn(orbit: OrbitCamera): void {
    this.#cameras.follow(orbit)
    this.host.turned()
  }

  probeNext(): void {
    const report = this.#shown?.report
    if (!report) return
    const next = nextCandidate(report, this.host.state().probe)
    this.#spokenProbe.announce(next)
    this.#probe(next.point)
  }

  showMinimum(): void {
    const report = this.#shown?.report
    if (!report) return
    const { faceDisplay, section } = sliceOf(sceneSlice, this.host.state())
    const inside = lowerInside(report)
    const change = (change: Partial<SceneState>) => this.host.dispatch(sliceChange(sceneSlice, change))
    if (inside) change({ faceDisplay: 'inside', section: { ...section, value: inside.point[section.axis] } })
    else if (!this.#pane.turnTo(report.minimizer.point)) change({ faceDisplay: 'see-through' })
    else if (faceDisplay !== 'see-through') change({ faceDisplay: 'opaque' })
  }

  toggleReference(): void {
    const referenceShown = !isReferenceShown(this.host.state())
    if (!referenceShown && this.#reference?.element.matches(':focus')) this.#pane.element.focus()
    this.host.dispatch(sliceChange(sceneSlice, { referenceShown }))
  }

  #probeValue(value: number | null): void {
    const report = this.#shown?.report
    if (report) this.#probe(value === null ? null : pointOfValue(report, value))
  }

  /** Marks a point that no pane's pointer is at. */
  #probe(point: Vec3 | null): void {
    this.#pane.inputs.probe.letGo()
    this.#reference?.inputs.probe.letGo()
    this.host.dispatch({ type: 'probe', point })
  }

  #layOut(): void {
    this.#isLaidOut = true
    this.root.style.visibility = 'hidden'
    this.host.requestFrame()
  }

  #onResize(): void {
    this.#sizeMayDiffer = true
    this.host.requestFrame()
  }

  /** Lays out the panes. Returns the element's camera from before if its pane has another size now, else null. */
  #resize(state: State): { readonly camera: CameraView | null } | null {
    const before = this.#shown?.state
    const referenceShown = isReferenceShown(state)
    if (!this.#sizeMayDiffer && referenceShown === (before !== undefined && isReferenceShown(before))) return null
    this.#sizeMayDiffer = false
    if (referenceShown) this.#reference ??= this.#createReference()
    if (this.#reference) this.#reference.root.hidden = !referenceShown
    const camera = before ? this.#pane.fitting.cameraView(before.vertices) : null
    const isResized = this.#layout.measure(referenceShown)
    if (referenceShown) this.#reference?.resize(this.#layout.unit)
    this.#pane.resize(this.#layout)
    return isResized ? { camera } : null
  }

  #createReference(): ReferenceCube {
    const reference = new ReferenceCube(this, this.#asked?.referenceCamera ?? null)
    this.#cameras.other = reference.orbit
    this.root.append(reference.root)
    return reference
  }

  /** Turns the cameras as a program asked for it, once. */
  #look({ state }: Frame): void {
    const { cameras } = state
    if (cameras === null || cameras === this.#asked) return
    this.#asked = cameras
    this.#reference?.look(cameras.referenceCamera)
    this.#pane.look(state, cameras.camera) // the last one leads where they are linked
  }

  /** If only the probe has changed, nothing else is touched. */
  #draw(frame: Frame, isFigure = false): void {
    const { state, report, probe } = frame
    const { pane } = this.#layout
    const reference = isReferenceShown(state) ? this.#reference : null
    const own = this.#pane.prepare(state)
    const viewports = reference ? [own, reference.prepare(state)] : [own]
    const isOther = this.#painting.paint(frame, this.#layout, viewports, isFigure)
    if (isOther || this.#pane.hasNewDrag || this.#differs(frame)) {
      this.#pane.update(frame, pane)
      this.#controls.update(state, report)
      this.#help.update(sliceOf(controlsSlice, state))
      reference?.update(frame)
    }
    const colour = this.#painting.colourAt(frame)
    this.#pane.updateProbe(probe, colour, state, pane)
    reference?.updateProbe(probe, colour)
  }

  #drawColourBar({ state, report, probe }: Frame): void {
    const { ramp } = this.#painting
    if (ramp === null || this.#layout.isEmpty) return
    const { isNarrow, barLength: length } = this.#layout.pane
    this.#colourBar.update({ state, report, probe, scale: scaleOf(state, report), ramp, upright: !isNarrow, length })
  }

  /** True if a frame has anything new but the probe. */
  #differs(frame: Frame): boolean {
    const { state, report } = frame
    const before = this.#shown
    if (before === null || before.report !== report || placeMarksOf(before) !== placeMarksOf(frame)) return true
    const keys = Object.keys(state) as (keyof State)[]
    return keys.some(key => key !== 'probe' && !Object.is(state[key], before.state[key]))
  }
}

function isReferenceShown(state: State): boolean {
  return sliceOf(sceneSlice, state).referenceShown
}

/** The scene among the panels. `prepare` asks the browser for what takes it longest. */
export const scene = {
  name: 'scene',
  region: 'stage',
  create: (host: ViewContext): View => new Scene(host),
  styles,
  prepare: (): void => void faceContext(),
  slice: sceneSlice,
} as const
