/**
 * Mouse, pen and touch on the handles. One pointer at a time, captured; a pointer elsewhere goes on to the orbit controls, which
 * never hear of one that drags. A drag is one gesture: release commits, Escape and pointercancel restore. A finger turns the view
 * once its way cannot be a scroll of the page.
 */
import { type Axis, VERTEX_COUNT, vertexOf } from '../../model/hexahedron'
import { type DragKeys, heldByChips } from '../../views/scene-slices'
import type { Pose } from '../space/orbit-camera'
import { extentOf } from '../space/world'
import type { InputTarget } from './input-target'
import { pickHandle, pickRadius } from './picking'
import { VertexDrag } from './vertex-drag'

/** Units that a pressed pointer may tremble before it drags. */
const STILL = { touch: 4, other: 1.5 }

/** Units, of CSS pixels, in which a finger shows its way, and beyond which the browser would have taken it for a scroll. */
const WAY = { shown: 8, untaken: 40 }

/** A pointer beside the handles. */
interface Swipe {
  readonly x: number
  readonly y: number
  /** The camera before it, which a pointercancel restores. */
  readonly pose: Pose
  turns: boolean
}

interface Grip {
  readonly pointerId: number
  readonly vertex: number
  readonly byTouch: boolean
  readonly drag: VertexDrag
  readonly x: number
  readonly y: number
  /** The latest pointer position. */
  nowX: number
  nowY: number
  moving: boolean
}

const AXES: Readonly<Record<string, Axis>> = { x: 0, y: 1, z: 2 }

export class PointerInput {
  readonly #target: InputTarget
  readonly #commitKeys: () => void
  readonly #listening = new AbortController()
  /** Pointers that the orbit controls have. */
  readonly #orbiting = new Set<number>()
  #swipe: Swipe | null = null
  #grip: Grip | null = null
  #axis: Axis | null = null
  #hovered: number | null = null

  /** `commitKeys` ends a gesture of the keyboard, if one is running. */
  constructor(target: InputTarget, commitKeys: () => void) {
    this.#target = target
    this.#commitKeys = commitKeys
    const { element } = target
    const early = { capture: true, signal: this.#listening.signal }
    element.addEventListener('pointerdown', this.#onDown, early)
    element.addEventListener('pointermove', this.#onMove, early)
    element.addEventListener('pointerup', this.#onUp, early)
    element.addEventListener('pointercancel', this.#onCancel, early)
    element.addEventListener('lostpointercapture', this.#onCancel, early)
    element.addEventListener('pointerleave', this.#onLeave, { signal: this.#listening.signal })
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
    if (!event.isTrusted) return // ours, for the orbit controls
    if (this.#grip !== null) {
      event.stopImmediatePropagation()
      event.preventDefault()
      return
    }
    this.#target.element.dataset.pointed = '' // no outline when a pointer gives the focus
    this.#target.element.focus({ preventScroll: true })
    const vertex = event.button === 0 && this.#orbiting.size === 0 ? this.#pick(event) : null
    if (vertex === null) {
      if (this.#orbiting.size === 0) {
        const { pose } = this.#target.orbit
        this.#swipe = { ...this.#target.positionOf(event), pose, turns: event.pointerType === 'mouse' }
      }
      this.#orbiting.add(event.pointerId)
      return
    }
    event.stopImmediatePropagation()
    event.preventDefault()
    this.#take(vertex, event)
  }

  #take(vertex: number, event: PointerEvent): void {
    const { element, camera, world, host } = this.#target
    this.#commitKeys()
    const { vertices } = host.state()
    const { x, y } = this.#target.positionOf(event)
    const position = vertexOf(vertices, vertex)
    const drag = new VertexDrag({ camera, world, position, extent: extentOf(vertices), x, y })
    const byTouch = event.pointerType === 'touch'
    this.#grip = { pointerId: event.pointerId, vertex, byTouch, drag, x, y, nowX: x, nowY: y, moving: false }
    this.#axis = null
    element.setPointerCapture(event.pointerId)
    host.dispatch({ type: 'select-vertex', vertex })
    this.#hover(vertex)
    element.dataset.cursor = 'grabbing'
  }

  readonly #onMove = (event: PointerEvent): void => {
    const grip = this.#grip
    if (grip === null) {
      if (this.#orbiting.size > 0) this.#follow(event)
      else if (event.pointerType !== 'touch') this.#hover(this.#pick(event))
      return
    }
    event.stopImmediatePropagation()
    if (event.pointerId !== grip.pointerId) return
    const { x, y } = this.#target.positionOf(event)
    grip.nowX = x
    grip.nowY = y
    if (!grip.moving) {
      const still = grip.byTouch ? STILL.touch : STILL.other
      if (Math.hypot(x - grip.x, y - grip.y) < still) return
      grip.moving = true
      this.#target.host.dispatch({ type: 'begin-gesture', by: 'pointer' })
    }
    this.#drag(event)
  }

  /** The orbit controls begin where the finger has shown that it turns. */
  #follow(event: PointerEvent): void {
    const swipe = this.#swipe
    if (swipe === null || swipe.turns) return
    const { x, y } = this.#target.positionOf(event)
    const [across, along] = [Math.abs(x - swipe.x), Math.abs(y - swipe.y)]
    const isMany = this.#orbiting.size > 1
    swipe.turns = isMany || along > WAY.untaken || (across > WAY.shown && across > along)
    event.stopImmediatePropagation()
    if (!swipe.turns || isMany) return
    for (const type of ['pointercancel', 'pointerdown'])
      this.#target.element.dispatchEvent(new PointerEvent(type, event))
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
    const to = grip.drag.moveTo(grip.nowX, grip.nowY, keys)
    this.#target.showDrag({ axis: keys.axis, snaps: keys.snap, byTouch: grip.byTouch })
    this.#target.host.dispatch({ type: 'move-vertex', vertex: grip.vertex, to })
  }

  readonly #onUp = (event: PointerEvent): void => {
    this.#orbiting.delete(event.pointerId)
    if (this.#grip?.pointerId !== event.pointerId) return
    event.stopImmediatePropagation()
    this.#end('commit-gesture')
    this.#hover(event.pointerType === 'touch' ? null : this.#pick(event))
  }

  readonly #onCancel = (event: PointerEvent): void => {
    if (!event.isTrusted) return
    const wasOrbiting = this.#orbiting.delete(event.pointerId)
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
    if (this.#grip !== null || !ours) event.stopImmediatePropagation()
  }

  readonly #onDoubleClick = (event: MouseEvent): void => {
    if (this.#pick(event) === null) this.#target.fit(false)
  }

  #pick(event: MouseEvent): number | null {
    const at = this.#target.positionOf(event)
    const type = event instanceof PointerEvent ? event.pointerType : 'mouse'
    const handles = this.#target.handles()
    if (handles.length !== VERTEX_COUNT) return null
    return pickHandle(handles, at, pickRadius(type), this.#target.host.state().selectedVertex)
  }

  #hover(vertex: number | null): void {
    this.#target.element.dataset.cursor = vertex === null ? 'orbit' : 'grab'
    if (vertex === this.#hovered) return
    this.#hovered = vertex
    this.#target.showHover(vertex)
  }
}
