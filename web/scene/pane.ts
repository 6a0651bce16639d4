/** A pane of the scene with a camera of its own: its element on the screen, the overlay over it, and its inputs. */
import type { Vec3 } from '../model/hexahedron'
import { type State, sliceOf } from '../model/state'
import { placeIn, stretchOf } from '../views/place-in'
import { sceneSlice, scriptSlice } from '../views/scene-slices'
import type { ViewContext } from '../views/view'
import { pointUnder } from './input/face-hit'
import type { InputTarget } from './input/input-target'
import { Inputs } from './input/inputs'
import { pickRadius } from './input/picking'
import { Overlay, type OverlayKind } from './overlay/overlay'
import type { HandleDrag } from './overlay/overlay-picture'
import type { Viewport } from './paint/picture'
import type { ScreenPoint } from './space/camera'
import type { Point } from './space/layout'
import { OrbitCamera } from './space/orbit-camera'
import { Sight } from './space/sight'
import type { World } from './space/world'

/** The scene as its panes see it. */
export interface PaneScene extends Pick<InputTarget, 'probeNext' | 'showMinimum' | 'toggleReference'> {
  readonly host: ViewContext
  /** Called at every move of a pane's camera. */
  onTurn(orbit: OrbitCamera): void
}

export abstract class Pane implements InputTarget {
  readonly element = document.createElement('div')
  readonly host: ViewContext
  readonly orbit: OrbitCamera
  readonly inputs: Inputs
  abstract readonly movesVertices: boolean
  abstract readonly world: World
  protected readonly overlay: Overlay
  /** The vertices on the screen when the picture was painted. */
  protected seen: readonly ScreenPoint[] = []
  /** What the faces hide in that picture. */
  sight: Sight
  readonly #scene: PaneScene
  /** The pointer's, while an animation shows the pane from its edge. */
  #lastPlace: Point = { x: 0, y: 0 }

  /** `description` is the id of the element that describes the pane. */
  constructor(scene: PaneScene, kind: OverlayKind, description: string) {
    this.#scene = scene
    this.host = scene.host
    this.overlay = new Overlay(kind, () => this.showMinimum())
    const { element } = this
    element.className = 'scene-stage'
    element.tabIndex = 0
    element.setAttribute('role', 'application')
    element.setAttribute('aria-describedby', description)
    element.append(this.overlay.root)
    this.orbit = new OrbitCamera(() => scene.onTurn(this.orbit))
    this.sight = new Sight([], this.camera, 'inside')
    this.inputs = new Inputs(this)
  }

  get camera() {
    return this.orbit.camera
  }

  /** The vertices in world space as they are now. */
  abstract vertices(): readonly Vec3[]

  abstract fit(toDefault: boolean): void

  showHover(_vertex: number | null): void {}

  showDrag(_drag: HandleDrag | null): void {}

  positionOf(event: MouseEvent): Point {
    const { width, height } = this.camera
    const { x, y } = placeIn(this.element, event) ?? this.#lastPlace
    this.#lastPlace = { x, y }
    return { x: x * width, y: y * height }
  }

  /** Where the element is seen smaller than it is, as many pixels of the screen. */
  pickRadius(pointerType: string): number {
    return pickRadius(pointerType) / Math.min(1, stretchOf(this.element))
  }

  handles(): readonly ScreenPoint[] {
    return this.movesVertices ? this.seen : []
  }

  pointAt(x: number, y: number): Vec3 | null {
    const { selectedVertex, ...now } = this.host.state()
    const state = { ...sliceOf(sceneSlice, now), ...sliceOf(scriptSlice, now), selectedVertex }
    return pointUnder({ camera: this.camera, vertices: this.vertices(), handles: this.seen, state }, x, y)
  }

  turn(right: number, up: number): void {
    this.orbit.turn(right, up)
  }

  zoom(factor: number): void {
    this.orbit.zoom(factor)
  }

  probeNext(): void {
    this.#scene.probeNext()
  }

  showMinimum(): void {
    this.#scene.showMinimum()
  }

  toggleReference(): void {
    this.#scene.toggleReference()
  }

  dispose(): void {
    this.inputs.dispose()
  }

  /** Follows the vertices and the camera before the picture is painted. */
  protected viewport(vertices: readonly Vec3[], state: State, left = 0, top = 0): Viewport {
    const { camera } = this
    camera.enclose(vertices)
    this.seen = vertices.map(vertex => camera.project(vertex))
    this.sight = new Sight(
      vertices,
      camera,
      sliceOf(sceneSlice, state).faceDisplay,
      sliceOf(scriptSlice, state).hiddenFaces,
    )
    return { left, top, vertices, camera }
  }
}
