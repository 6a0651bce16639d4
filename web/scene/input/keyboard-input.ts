/**
 * The scene by keyboard alone. Moves go along coordinate axes, each arrow along the one nearest to it on the screen, so that
 * they give readable numbers. A key held down is one gesture until it is released.
 */

import { VERTEX_COUNT, type Vec3, vertexOf } from '../../model/hexahedron'
import { sliceChange, sliceOf } from '../../model/state'
import { isForeign, isSmallStep } from '../../views/point-steps'
import { type FaceDisplay, sceneSlice } from '../../views/scene-slices'
import type { SceneCamera } from '../space/camera'
import { addDecimal, keyStep, lengthOf } from '../space/decimal-step'
import { at, map3 } from '../space/vec3'
import { extentOf } from '../space/world'
import type { InputTarget } from './input-target'

/** The coordinate axis that one of right, up and towards the eye stands for, and its sign. */
export interface AxisMove {
  readonly axis: 0 | 1 | 2
  readonly sign: 1 | -1
}

const ORDERS = [
  [0, 1, 2],
  [0, 2, 1],
  [1, 0, 2],
  [1, 2, 0],
  [2, 0, 1],
  [2, 1, 0],
] as const

/** The axes of right, up and towards: the assignment, of the six, that agrees best with the screen. */
export function axisMoves(cameraAxes: readonly [Vec3, Vec3, Vec3]): readonly [AxisMove, AxisMove, AxisMove] {
  const agreement = (order: readonly number[]) =>
    order.reduce((sum, axis, k) => sum + Math.abs(at(cameraAxes[k] as Vec3, axis)), 0)
  const best = ORDERS.reduce((a, b) => (agreement(b) > agreement(a) ? b : a))
  const move = (k: 0 | 1 | 2): AxisMove => ({ axis: best[k], sign: at(cameraAxes[k], best[k]) < 0 ? -1 : 1 })
  return [move(0), move(1), move(2)]
}

/** The direction, of right, up and towards, that a key moves along, and its sign. */
const MOVES: Readonly<Record<string, readonly [0 | 1 | 2, 1 | -1]>> = {
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
  ArrowUp: [1, 1],
  ArrowDown: [1, -1],
  PageDown: [2, 1],
  PageUp: [2, -1],
}

/** Steps to the right and up by which a key turns a camera, if vertices cannot be moved. */
const TURNS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

/** One face after another, and all of them again. */
export function nextDisplay(display: FaceDisplay, by: 1 | -1): FaceDisplay {
  const at = typeof display === 'number' ? display : by > 0 ? -1 : 6
  const next = at + by
  return next < 0 || next > 5 ? 'opaque' : next
}

export class KeyboardInput {
  readonly #target: InputTarget
  readonly #held = new Set<string>()
  #moving = false

  constructor(target: InputTarget) {
    this.#target = target
  }

  onKeyDown(event: KeyboardEvent): void {
    if (isForeign(event)) return
    const arrow = this.#target.movesVertices ? this.#move(event) : this.#turn(event)
    if (arrow || this.#command(event)) event.preventDefault()
  }

  onKeyUp(event: KeyboardEvent): void {
    if (this.#held.delete(event.key) && this.#held.size === 0) this.commit()
  }

  /** Ends the running gesture, if there is one, when the key is released or the focus lost. */
  commit(): void {
    this.#finish('commit-gesture')
  }

  #finish(how: 'commit-gesture' | 'cancel-gesture'): void {
    this.#held.clear()
    if (!this.#moving) return
    this.#moving = false
    this.#target.host.dispatch({ type: how })
  }

  #move(event: KeyboardEvent): boolean {
    const { key, shiftKey } = event
    const move = MOVES[key]
    const { host, camera } = this.#target
    if (move === undefined) return false
    if (!this.#moving) {
      this.#choose(host.state().selectedVertex)
      this.#moving = true
      host.dispatch({ type: 'begin-gesture', by: 'keyboard' })
    }
    this.#held.add(key)
    const { vertices, selectedVertex, gestureStart } = host.state()
    const from = vertexOf(vertices, selectedVertex)
    const step = keyStep(extentOf(gestureStart ?? vertices))
    const scale = (shiftKey ? 1 : 0) - (isSmallStep(event) ? 1 : 0)
    const length = lengthOf({ ...step, exponent: Math.max(-323, step.exponent + scale) })
    const to = moved(from, camera, move, length)
    host.dispatch({ type: 'move-vertex', vertex: selectedVertex, to })
    return true
  }

  #turn(event: KeyboardEvent): boolean {
    const turn = TURNS[event.key]
    if (turn === undefined || isSmallStep(event)) return false
    this.#target.turn(...turn)
    return true
  }

  #command(event: KeyboardEvent): boolean {
    const { key } = event
    if (isSmallStep(event)) return false
    if (key === 'Escape') return this.#escape()
    const command = this.#commands[key.length === 1 ? key.toLowerCase() : key]
    if (command) command()
    else if (/^[0-7]$/.test(key)) this.#choose(Number(key))
    else return false
    return true
  }

  readonly #commands: Readonly<Record<string, () => void>> = {
    '[': () => this.#chooseNext(-1),
    ']': () => this.#chooseNext(1),
    p: () => this.#target.probeNext(),
    m: () => this.#target.showMinimum(),
    r: () => this.#target.toggleReference(),
    a: () => this.#target.turn(-1, 0),
    d: () => this.#target.turn(1, 0),
    w: () => this.#target.turn(0, 1),
    s: () => this.#target.turn(0, -1),
    '+': () => this.#target.zoom(1.2),
    '=': () => this.#target.zoom(1.2),
    '-': () => this.#target.zoom(1 / 1.2),
    f: () => this.#target.fit(false),
    Home: () => this.#target.fit(true),
    t: () => this.#show(this.#display === 'see-through' ? 'opaque' : 'see-through'),
    i: () => this.#show(this.#display === 'inside' ? 'opaque' : 'inside'),
    '.': () => this.#show(nextDisplay(this.#display, 1)),
    ',': () => this.#show(nextDisplay(this.#display, -1)),
  }

  /** False if there is nothing to take back. */
  #escape(): boolean {
    const { host } = this.#target
    if (this.#moving) this.#finish('cancel-gesture')
    else if (host.state().probe === null) return false
    else host.dispatch({ type: 'probe', point: null })
    return true
  }

  get #display(): FaceDisplay {
    return sliceOf(sceneSlice, this.#target.host.state()).faceDisplay
  }

  #show(faceDisplay: FaceDisplay): void {
    this.#target.host.dispatch(sliceChange(sceneSlice, { faceDisplay }))
  }

  #chooseNext(by: 1 | -1): void {
    this.#choose((this.#target.host.state().selectedVertex + by + VERTEX_COUNT) % VERTEX_COUNT)
  }

  #choose(vertex: number): void {
    this.commit()
    this.#target.host.dispatch({ type: 'select-vertex', vertex })
  }
}

function moved(
  from: Vec3,
  camera: SceneCamera,
  [direction, forth]: readonly [0 | 1 | 2, 1 | -1],
  length: number,
): Vec3 {
  const { axis, sign } = axisMoves(camera.axes())[direction]
  return map3(k => (k === axis ? addDecimal(at(from, k), sign * forth * length) : at(from, k)))
}
