/** The element in physical space, with vertices to move. */
import type { JacobianReport } from '../core/report'
import { formatJacdet } from '../model/decimal'
import type { Vec3 } from '../model/hexahedron'
import { type State, sliceOf } from '../model/state'
import { previewSlice } from '../views/scene-slices'
import type { Frame } from '../views/view'
import type { HandleDrag } from './overlay/overlay-picture'
import { Readout } from './overlay/readout'
import type { Viewport } from './paint/picture'
import { Pane, type PaneScene } from './pane'
import { type Change, Fitting } from './space/fitting'
import type { Layout, PaneLayout } from './space/layout'
import { verticesInWorld, type World } from './space/world'

export class ElementPane extends Pane {
  readonly root = document.createElement('div')
  readonly fitting = new Fitting(this.orbit)
  readonly #readout = new Readout()
  #isReadonly: boolean | null = null
  #drag: HandleDrag | null = null
  #drawnDrag: HandleDrag | null = null
  /** True if the gesture last drawn is of the pointer here, under which the picture must not move. */
  #wasDragging = false

  constructor(scene: PaneScene, description: string) {
    super(scene, { letters: ['x', 'y', 'z'], isFixed: false }, description)
    this.root.className = 'scene-pane'
    this.element.dataset.cursor = 'orbit'
    this.overlay.root.append(this.#readout.root)
    this.root.append(this.element)
  }

  get movesVertices(): boolean {
    return !this.host.state().isReadonly
  }

  get world(): World {
    return this.fitting.world
  }

  /** True if the drag has changed since the overlay was drawn. */
  get hasNewDrag(): boolean {
    return this.#drag !== this.#drawnDrag
  }

  vertices(): readonly Vec3[] {
    return verticesInWorld(this.world, this.host.state().vertices)
  }

  name({ isReadonly }: State): void {
    if (isReadonly === this.#isReadonly) return
    this.#isReadonly = isReadonly
    const name = isReadonly ? 'The hexahedron in space' : 'The hexahedron in space, eight vertices to move'
    this.element.setAttribute('aria-label', name)
  }

  resize({ unit, pane, isEmpty }: Layout): void {
    this.unit = unit
    if (!isEmpty) this.camera.resize(pane.width, pane.height, pane.insets)
  }

  /** Looks elsewhere if the frame asks for it. `changesMedium` says whether it is the first on paper or again on the screen. */
  aim({ state, isForPaper }: Frame, changesMedium: boolean, change: Omit<Change, 'isDragged'>): void {
    if (isForPaper) this.fitting.putOnPaper(state.vertices)
    else if (changesMedium) this.fitting.leavePaper()
    else this.fitting.choose(state, { ...change, isDragged: this.#wasDragging })
    this.#wasDragging = this.inputs.isDragging
  }

  prepare({ vertices }: State): Viewport {
    return this.viewport(verticesInWorld(this.world, vertices), 0, 0)
  }

  update({ state, report }: Frame, { taken }: PaneLayout): void {
    this.#drawnDrag = this.#drag
    const { world, camera, seen: handles } = this
    const { preview } = sliceOf(previewSlice, state)
    this.overlay.update({ state, preview, report, world, camera, handles, drag: this.#drag, taken })
  }

  /** `colour` is that of jacdet at the probe. */
  updateProbe(probe: JacobianReport | null, colour: string, { referenceCube }: State, layout: PaneLayout): void {
    const words = probe ? `volume × ${formatJacdet(probe.jacdet, probe.exponent, referenceCube)}` : ''
    this.overlay.updateProbe(probe, { colour, words }, layout.readout)
    this.#readout.update(probe, referenceCube, layout)
  }

  override showHover(vertex: number | null): void {
    this.overlay.showHover(vertex)
  }

  override showDrag(drag: HandleDrag | null): void {
    this.#drag = drag
    this.inputs.probe.clear()
    this.host.requestFrame()
  }

  fit(toDefault: boolean): void {
    if (this.inputs.isDragging) return
    this.fitting.fit(this.host.state().vertices, toDefault)
    this.host.requestFrame()
  }
}
