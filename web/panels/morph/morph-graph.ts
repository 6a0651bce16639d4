/** The boundary minimum along the way, zero, the changes of the verdict and the present tau. */
import { formatJacdet } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { px, set, setText, show, svg } from '../../scene/paint/svg'
import { isNew } from '../../views/is-new'
import { say } from '../../words/say'
import { curveOf, heightOf } from './curve'
import type { Morph } from './morph-answer'

const WIDTH = 340
const HEIGHT = 164
const [LEFT, RIGHT, TOP, BOTTOM] = [8, 8, 10, 36]

export class MorphGraph {
  readonly root = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', class: 'graph' })
  readonly #below = svg('path', { class: 'below' })
  readonly #curve = svg('path', { class: 'curve' })
  readonly #zero = svg('path', { class: 'zero' })
  readonly #zeroName = svg('text', { class: 'muted' }, 'J = 0')
  readonly #crossings = svg('path', { class: 'crossing' })
  readonly #here = svg('path', { class: 'here' })
  readonly #dot = svg('circle', { class: 'dot', r: 4.5 })
  readonly #ends = [
    svg('text', { class: 'end', x: LEFT, y: HEIGHT - 4 }, 'A'),
    svg('text', { class: 'end', x: WIDTH - RIGHT, y: HEIGHT - 4, 'text-anchor': 'end' }, 'B'),
  ] as const
  readonly #values = [
    svg('text', { class: 'muted', x: LEFT + 14, y: HEIGHT - 4 }),
    svg('text', { class: 'muted', x: WIDTH - RIGHT - 14, y: HEIGHT - 4, 'text-anchor': 'end' }),
  ] as const

  constructor() {
    this.root.append(this.#below, this.#zero, this.#zeroName, this.#curve, this.#crossings, this.#here, this.#dot)
    this.root.append(...this.#ends, ...this.#values)
  }

  /** `here` is the present place, null where the element is not on the way. */
  update(morph: Morph, here: number | null, cube: ReferenceCube): void {
    if (isNew(this, morph, cube)) this.#drawWay(morph, cube)
    show(this.#here, here !== null)
    show(this.#dot, here !== null)
    if (here === null) return
    const curve = curveOf(morph)
    const [x, y] = this.#place({ tau: here, height: heightOf(curve, here) })
    set(this.#here, { d: `M${px(x)} ${TOP}V${HEIGHT - BOTTOM}` })
    set(this.#dot, { cx: px(x), cy: px(y) })
  }

  #place({ tau, height }: { readonly tau: number; readonly height: number }): [number, number] {
    return [LEFT + tau * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - height * (HEIGHT - TOP - BOTTOM)]
  }

  #drawWay(morph: Morph, cube: ReferenceCube): void {
    const curve = curveOf(morph)
    const places = curve.points.map(point => this.#place(point))
    const line = places.map(([x, y]) => `${px(x)} ${px(y)}`).join('L')
    const [, zero] = this.#place({ tau: 0, height: curve.zero })
    set(this.#curve, { d: `M${line}` })
    set(this.#zero, { d: `M${LEFT} ${px(zero)}H${WIDTH - RIGHT}` })
    // The label stands at the end where the curve is farther away.
    const [atA, atB] = [places[0]?.[1] ?? zero, places.at(-1)?.[1] ?? zero]
    const isAtA = Math.abs(atA - zero) > Math.abs(atB - zero)
    const isAbove = (isAtA ? atA : atB) > zero
    const name = { x: isAtA ? LEFT : WIDTH - RIGHT, y: px(zero + (isAbove ? -5 : 13)) }
    set(this.#zeroName, { ...name, 'text-anchor': isAtA ? 'start' : 'end' })
    const under = places.map(([x, y]) => `${px(x)} ${px(Math.max(y, zero))}`).join('L')
    set(this.#below, { d: `M${LEFT} ${px(zero)}L${under}L${WIDTH - RIGHT} ${px(zero)}Z` })
    const marks = morph.crossings.map(({ validTau }) => {
      const [x] = this.#place({ tau: validTau, height: 0 })
      return `M${px(x)} ${px(zero - 6)}V${px(zero + 6)}`
    })
    set(this.#crossings, { d: marks.join('') })
    const [first, last] = [morph.samples[0], morph.samples.at(-1)]
    const texts = [first, last].map(sample => (sample ? formatJacdet(sample.minimum, sample.exponent, cube) : ''))
    this.#values.forEach((value, i) => {
      setText(value, texts[i] ?? '')
    })
    set(this.root, { 'aria-label': spoken(morph, texts) })
  }
}

function spoken({ crossings }: Morph, [first, last]: readonly string[]): string {
  const changes = crossings.map(({ validTau }) => validTau.toFixed(3)).join(', ')
  const ends = { first: first ?? '', last: last ?? '' }
  return crossings.length === 0
    ? say('Boundary minimum from A, {first}, to B, {last}; no change of the verdict was found', ends)
    : say('Boundary minimum from A, {first}, to B, {last}; the verdict changes at tau {changes}', { ...ends, changes })
}
