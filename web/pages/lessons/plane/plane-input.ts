/**
 * Pointer and keys on the two pictures of the plane, as on those of the lens: a drag is one gesture with the pointer captured, Escape
 * takes it back; keys choose and move corners by decimal steps. On the square they move the point that is marked.
 */
import { vertexOf } from '../../../model/hexahedron'
import type { Action, State } from '../../../model/state'
import { pickRadius } from '../../../scene/input/picking'
import { addDecimal, gridStep, keyStep, lengthOf, roundingStep, roundTo } from '../../../scene/space/decimal-step'
import { extentOf } from '../../../scene/space/world'
import { placeIn } from '../../../views/place-in'
import { isForeign, isSmallStep } from '../../../views/point-steps'
import { baseOf, CORNER_COUNT, preimages, type Vec2 } from './quadrilateral'
import type { PlaneView } from './view'

export interface PlaneTarget {
  readonly element: SVGElement
  readonly square: SVGElement
  readonly view: (of: 'element' | 'square') => PlaneView
  readonly state: () => State
  readonly dispatch: (action: Action) => void
  readonly probe: () => Vec2 | null
  readonly setProbe: (point: Vec2 | null) => void
  /** True if corners may be moved. */
  readonly canMove: () => boolean
  /** A corner was pressed, not dragged. */
  readonly press: (corner: number) => void
  readonly select: (corner: number) => void
  readonly selected: () => number
  /** A gesture has ended, by which the reader moved a corner. */
  readonly moved: () => void
}

interface Grip {
  readonly pointerId: number
  readonly corner: number
  /** From the pointer to the corner, in pixels. */
  readonly offset: Vec2
  readonly start: Vec2
  readonly from: Vec2
  readonly still: number
  isMoving: boolean
}

/** Pixels that a pressed pointer may tremble before it drags. */
const STILL = { touch: 4, other: 1.5 }
const PROBE_STEP = 0.05

const ARROWS: Readonly<Record<string, Vec2>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

export function listen(target: PlaneTarget): void {
  const { element, square, state, dispatch } = target
  const held = new Set<string>()
  let grip: Grip | null = null

  /** The pictures share the box around them, the square at its right. */
  const placeOf = (event: PointerEvent, on: SVGElement): Vec2 => {
    const panes = on.parentElement as HTMLElement
    const { clientWidth: width, clientHeight: height } = panes
    const { x, y } = placeIn(panes, event) ?? { x: 0, y: 0 }
    return [x * width - (on === square ? width - square.clientWidth : 0), y * height]
  }
  const cornerAt = (place: Vec2, radius: number): number | null => {
    const { toScreen } = target.view('element')
    const distances = baseOf(state().vertices).map(corner => {
      const [x, y] = toScreen(corner)
      return Math.hypot(x - place[0], y - place[1])
    })
    const least = Math.min(...distances)
    if (least > radius) return null
    // Of corners in one place the chosen one.
    return distances[target.selected()] === least ? target.selected() : distances.indexOf(least)
  }
  const move = (corner: number, [x, y]: Vec2): void => {
    for (const [vertex, z] of [
      [corner, 0],
      [corner + CORNER_COUNT, 1],
    ] as const)
      dispatch({ type: 'move-vertex', vertex, to: [x, y, z] })
  }

  const drag = (event: PointerEvent, { corner, offset, from }: Grip): void => {
    const { toPlane, scale } = target.view('element')
    const [x, y] = placeOf(event, element)
    const to = toPlane([x + offset[0], y + offset[1]])
    const step = event.altKey ? gridStep(extentOf(state().gestureStart ?? state().vertices)) : roundingStep(1 / scale)
    const along = (i: 0 | 1) => (Math.abs(to[i] - from[i]) < lengthOf(step) / 2 ? from[i] : roundTo(to[i], step))
    move(corner, [along(0), along(1)])
  }
  const end = (how: 'commit-gesture' | 'cancel-gesture'): void => {
    if (!grip) return
    const { pointerId, isMoving, corner } = grip
    grip = null
    if (element.hasPointerCapture(pointerId)) element.releasePointerCapture(pointerId)
    delete element.dataset.dragging
    if (!isMoving) {
      if (how === 'commit-gesture') target.press(corner)
      return
    }
    dispatch({ type: how })
    target.moved()
  }
  const endKeys = (how: 'commit-gesture' | 'cancel-gesture'): void => {
    if (held.size === 0) return
    held.clear()
    dispatch({ type: how })
    target.moved()
  }
  const point = (event: PointerEvent, on: 'element' | 'square'): void => {
    const [x, y] = target.view(on).toPlane(placeOf(event, on === 'element' ? element : square))
    if (on === 'square') target.setProbe([clamped(x), clamped(y)])
    else {
      const [found] = preimages(baseOf(state().vertices), [x, y])
      if (found) target.setProbe(found)
    }
  }

  element.addEventListener('pointerdown', event => {
    element.focus({ preventScroll: true })
    if (grip || event.button !== 0) return
    const place = placeOf(event, element)
    const corner = cornerAt(place, pickRadius(event.pointerType))
    if (corner === null) {
      if (event.pointerType === 'touch') point(event, 'element')
      return
    }
    event.preventDefault()
    endKeys('commit-gesture')
    target.select(corner)
    const from = vertexOf(state().vertices, corner).slice(0, 2) as unknown as Vec2
    const [x, y] = target.view('element').toScreen(from)
    const still = event.pointerType === 'touch' ? STILL.touch : STILL.other
    grip = {
      pointerId: event.pointerId,
      corner,
      offset: [x - place[0], y - place[1]],
      start: place,
      from,
      still,
      isMoving: false,
    }
    element.setPointerCapture(event.pointerId)
    element.dataset.dragging = ''
  })
  element.addEventListener('pointermove', event => {
    if (!grip) {
      if (event.pointerType !== 'touch') point(event, 'element')
      return
    }
    if (event.pointerId !== grip.pointerId || !target.canMove()) return
    const [x, y] = placeOf(event, element)
    if (!grip.isMoving) {
      if (Math.hypot(x - grip.start[0], y - grip.start[1]) < grip.still) return
      grip.isMoving = true
      dispatch({ type: 'begin-gesture' })
    }
    drag(event, grip)
  })
  element.addEventListener('pointerup', event => {
    if (event.pointerId === grip?.pointerId) end('commit-gesture')
  })
  for (const type of ['pointercancel', 'lostpointercapture'] as const)
    element.addEventListener(type, event => {
      if (event.pointerId === grip?.pointerId) end('cancel-gesture')
    })
  // A finger on a corner drags it: then, and only then, the page does not scroll.
  element.addEventListener(
    'touchstart',
    event => {
      if (event.cancelable && grip) event.preventDefault()
    },
    { passive: false },
  )
  for (const type of ['pointerdown', 'pointermove'] as const)
    square.addEventListener(type, event => {
      if (type === 'pointerdown') square.focus({ preventScroll: true })
      point(event, 'square')
    })

  element.addEventListener('keydown', event => {
    const { key, shiftKey } = event
    if (isForeign(event)) return
    const arrow = ARROWS[key]
    if (key === 'Escape') {
      if (grip) end('cancel-gesture')
      else if (held.size > 0) endKeys('cancel-gesture')
      else target.setProbe(null)
    } else if (/^[0-3]$/.test(key)) {
      endKeys('commit-gesture')
      target.select(Number(key))
    } else if (key === '[' || key === ']') {
      endKeys('commit-gesture')
      target.select((target.selected() + (key === ']' ? 1 : CORNER_COUNT - 1)) % CORNER_COUNT)
    } else if (key === 'Enter' || key === ' ') target.press(target.selected())
    else if (arrow && !grip) {
      if (target.canMove()) {
        if (held.size === 0) dispatch({ type: 'begin-gesture' })
        held.add(key)
        const step = keyStep(extentOf(state().gestureStart ?? state().vertices))
        const length = lengthOf({
          ...step,
          exponent: step.exponent + (shiftKey ? 1 : 0) - (isSmallStep(event) ? 1 : 0),
        })
        const corner = target.selected()
        const [x, y] = vertexOf(state().vertices, corner)
        move(corner, [addDecimal(x, arrow[0] * length), addDecimal(y, arrow[1] * length)])
      }
    } else return
    event.preventDefault()
  })
  element.addEventListener('keyup', ({ key }) => {
    if (held.has(key) && held.size === 1) endKeys('commit-gesture')
    else held.delete(key)
  })
  element.addEventListener('blur', () => endKeys('commit-gesture'))
  square.addEventListener('keydown', event => {
    const arrow = ARROWS[event.key]
    if (event.key === 'Escape') target.setProbe(null)
    else if (arrow && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const [xi, eta] = target.probe() ?? [0.5, 0.5]
      const step = PROBE_STEP * (event.shiftKey ? 5 : 1)
      target.setProbe([clamped(addDecimal(xi, arrow[0] * step)), clamped(addDecimal(eta, arrow[1] * step))])
    } else return
    event.preventDefault()
  })
}

const clamped = (value: number): number => Math.max(0, Math.min(1, value))
