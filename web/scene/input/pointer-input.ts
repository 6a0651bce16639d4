/**
 * Mouse, pen and touch on the handles, one pointer at a time, captured; a pointer elsewhere turns the view. A drag is one gesture:
 * release commits, Escape and pointercancel restore. A finger turns the view once its way cannot be a scroll of the page.
 *
 * What a hand does without meaning to, and how far it goes, is in CSS pixels of the screen, whatever the element's scale.
 */
import { type Axis, VERTEX_COUNT, vertexOf } from '../../model/hexahedron'
import { type DragKeys, heldByChips } from '../../views/scene-slices'
import type { Point } from '../space/layout'
import type { Pose } from '../space/orbit-camera'
import { extentOf } from '../space/world'
import type { InputTarget } from './input-target'
import { OrbitInput } from './orbit-input'
import { pickHandle } from './picking'
import { VertexDrag } from './vertex-drag'

/** Ways that a pressed pointer may tremble before it drags. */
const STILL = { touch: 4, other: 1.5 }

/** Ways after which a finger has shown where it goes, and the browser would have taken it for a scroll. */
const WAY = { shown: 8, untaken: 40 }

/** A pointer beside the handles. */
interface Swipe {
  readonly from: PointerEvent
  /** The camera before it, which a pointercancel restores. */
  readonly pose: Pose
  turns: boolean
}

interface Grip {
  readonly pointerId: number
  readonly vertex: number
  readonly byTouch: boolean
  readonly drag: VertexDrag
  readonly from: PointerEvent
  /** The latest position in the pane. */
  at: Point
  moving: boolean
}

const AXES: Readonly<Record<string, Axis>> = { x: 0, y: 1, z: 2 }

export class PointerInput {
  readonly #target: InputTarget
  readonly #commitKeys: () => void
  readonly #listening = new AbortController()
  readonly #orbiting: OrbitInput
  #swipe: Swipe | null = null
  #grip: Grip | null = null
  #axis: Axis | null = null
  #hovered: number | null = null

  /** `commitKeys` ends a gesture of the keyboard, if one is running. */
  constructor(target: InputTarget, commitKeys: () => void) {
    this.#target = target
    this.#commitKeys = commitKeys
    const { element } = target
    const { signal } = this.#listening
    const early = { capture: true, signal }
    this.#orbiting = new OrbitInput(target.orbit, signal)
    element.addEventListener('pointerdown', this.#onDown, early)
    element.addEventListener('pointerdown', this.#onPress, { signal })
    element.addEventListener('pointermove', this.#onMove, early)
    element.addEventListener('pointerup', this.#onUp, early)
    element.addEventListener('pointercancel', this.#onCancel, early)
    element.addEventListener('lostpointercapture', this.#onCancel, early)
    element.addEventListener('pointerleave', this.#onLeave, { signal })
    element.addEventListener('contextmenu', event => event.preventDefault(), { signal })
    element.addEventListener('touchstart', this.#onTouchStart, { ...early, passive: false })
    element.addEventListener('wheel', this.#onWheel, early)
    element.addEventListener('dblclick', this.#onDoubleClick, early)
  }

  get isDragging(): boolean {
    return this.#grip !== null
  }

  dispose(): void {
    this.cancel()
    this.#listening.abort()
  }

  /** Puts the vertex back. */
  cancel(): void {
    this.#end('cancel-gesture')
  }

  /** Keys while a drag is running: X, Y, Z, Shift and Alt act at once, Escape ends it. */
  onKey(event: KeyboardEvent): void {
    const down = event.type === 'keydown'
    if (down && event.key === 'Escape') {
      this.cancel()
    } else {
      const axis = event.ctrlKey || event.metaKey ? undefined : AXES[event.key.toLowerCase()]
      const concerns = axis !== undefined || event.key === 'Shift' || event.key === 'Alt'
      if (!concerns) return
      if (axis !== undefined) {
        if (down) this.#axis = axis
        else if (this.#axis === axis) this.#axis = null
      }
      this.#drag(event)
    }
    event.preventDefault()
  }

  readonly #onDown = (event: PointerEvent): void => {
    if (this.#grip !== null) {
      event.stopImmediatePropagation()
      event.preventDefault()
      return
    }
    this.#target.element.dataset.pointed = '' // no outline when a pointer gives the focus
    this.#target.element.focus({ preventScroll: true })
    const isFirst = this.#orbiting.isIdle
    const vertex = event.button === 0 && isFirst ? this.#pick(event) : null
    if (vertex === null) {
      const isMouse = event.pointerType === 'mouse'
      if (isFirst) this.#swipe = { from: event, pose: this.#target.orbit.pose, turns: isMouse }
      if (!isMouse) this.#orbiting.begin(event, this.#target.positionOf(event))
      return
    }
    event.stopImmediatePropagation()
    event.preventDefault()
    this.#take(vertex, event)
  }

  /** Words in the scene that are pressed keep the mouse's click to themselves; a finger's way may begin on them. */
  readonly #onPress = (event: PointerEvent): void => {
    this.#orbiting.begin(event, this.#target.positionOf(event))
    this.#target.element.setPointerCapture(event.pointerId)
  }

  #take(vertex: number, event: PointerEvent): void {
    const { element, camera, world, host } = this.#target
    this.#commitKeys()
    const { vertices } = host.state()
    const at = this.#target.positionOf(event)
    const position = vertexOf(vertices, vertex)
    const drag = new VertexDrag({ camera, world, position, extent: extentOf(vertices), ...at })
    const byTouch = event.pointerType === 'touch'
    this.#grip = { pointerId: event.pointerId, vertex, byTouch, drag, from: event, at, moving: false }
    this.#axis = null
    element.setPointerCapture(event.pointerId)
    host.dispatch({ type: 'select-vertex', vertex })
    this.#hover(vertex)
    element.dataset.cursor = 'grabbing'
  }

  readonly #onMove = (event: PointerEvent): void => {
    const grip = this.#grip
    if (grip === null) {
      if (!this.#orbiting.isIdle) this.#follow(event)
      else if (event.pointerType !== 'touch') this.#hover(this.#pick(event))
      return
    }
    event.stopImmediatePropagation()
    if (event.pointerId !== grip.pointerId) return
    grip.at = this.#target.positionOf(event)
    if (!grip.moving) {
      if (Math.hypot(...wayOf(grip.from, event)) < (grip.byTouch ? STILL.touch : STILL.other)) return
      grip.moving = true
      this.#target.host.dispatch({ type: 'begin-gesture', by: 'pointer' })
    }
    this.#drag(event)
  }

  /** The view begins to turn where the finger has shown that it does. */
  #follow(event: PointerEvent): void {
    const swipe = this.#swipe
    const at = this.#target.positionOf(event)
    if (swipe === null || swipe.turns) {
      this.#orbiting.move(event, at)
      return
    }
    const [across, along] = wayOf(swipe.from, event).map(Math.abs) as [number, number]
    swipe.turns = this.#orbiting.isByMany || along > WAY.untaken || (across > WAY.shown && across > along)
    if (swipe.turns) this.#orbiting.begin(event, at)
  }

  #drag({ shiftKey, altKey }: { readonly shiftKey: boolean; readonly altKey: boolean }): void {
    const grip = this.#grip
    if (grip === null || !grip.moving) return
    const held = heldByChips(this.#target.host.state())
    const keys: DragKeys = {
      axis: this.#axis ?? held.axis,
      depth: shiftKey || held.depth,
      snap: altKey || held.snap,
    }
    const to = grip.drag.moveTo(grip.at.x, grip.at.y, keys)
    this.#target.showDrag({ axis: keys.axis, snaps: keys.snap, byTouch: grip.byTouch })
    this.#target.host.dispatch({ type: 'move-vertex', vertex: grip.vertex, to })
  }

  readonly #onUp = (event: PointerEvent): void => {
    this.#orbiting.end(event.pointerId)
    if (this.#grip?.pointerId !== event.pointerId) return
    event.stopImmediatePropagation()
    this.#end('commit-gesture')
    this.#hover(event.pointerType === 'touch' ? null : this.#pick(event))
  }

  readonly #onCancel = (event: PointerEvent): void => {
    const wasOrbiting = this.#orbiting.end(event.pointerId)
    if (event.type === 'pointercancel' && wasOrbiting && this.#swipe) this.#target.orbit.pose = this.#swipe.pose
    if (this.#grip?.pointerId === event.pointerId) this.cancel()
  }

  #end(how: 'commit-gesture' | 'cancel-gesture'): void {
    const grip = this.#grip
    if (grip === null) return
    this.#grip = null
    const { element, host } = this.#target
    if (element.hasPointerCapture(grip.pointerId)) element.releasePointerCapture(grip.pointerId)
    this.#target.showDrag(null)
    if (grip.moving) host.dispatch({ type: how })
    this.#hover(null)
  }

  readonly #onLeave = (): void => {
    if (this.#grip === null) this.#hover(null)
  }

  /** A finger on a handle drags it and two fingers zoom: then, and only then, the page does not scroll. */
  readonly #onTouchStart = (event: TouchEvent): void => {
    if (event.cancelable && (this.#grip !== null || event.touches.length > 1)) event.preventDefault()
  }

  /** The wheel is the page's, unless the scene has the focus or Ctrl or Cmd is held. */
  readonly #onWheel = (event: WheelEvent): void => {
    const { element } = this.#target
    const ours = event.ctrlKey || event.metaKey || element.matches(':focus')
    if (this.#grip !== null) event.preventDefault()
    else if (ours) this.#orbiting.wheel(event, this.#target.positionOf(event))
  }

  readonly #onDoubleClick = (event: MouseEvent): void => {
    if (this.#pick(event) === null) this.#target.fit(false)
  }

  #pick(event: MouseEvent): number | null {
    const at = this.#target.positionOf(event)
    const type = event instanceof PointerEvent ? event.pointerType : 'mouse'
    const handles = this.#target.handles()
    if (handles.length !== VERTEX_COUNT) return null
    return pickHandle(handles, at, this.#target.pickRadius(type), this.#target.host.state().selectedVertex)
  }

  #hover(vertex: number | null): void {
    this.#target.element.dataset.cursor = vertex === null ? 'orbit' : 'grab'
    if (vertex === this.#hovered) return
    this.#hovered = vertex
    this.#target.showHover(vertex)
  }
}

function wayOf(from: PointerEvent, to: PointerEvent): readonly [right: number, down: number] {
  return [to.clientX - from.clientX, to.clientY - from.clientY]
}
