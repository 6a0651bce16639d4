/** The numbers at the point that is pointed at: in words on the screen, in one place, and as a sentence to be heard. */
import type { Candidate, JacobianReport } from '../../core/report'
import { formatJacdet, formatPoint, speakJacdet, speakNumber } from '../../model/decimal'
import { edgeName } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { set, setText, show, svg } from '../paint/svg'
import type { Box } from './label-place'

/** Right of the triad; where there is little room, under the colour bar. */
const PLACES = { wide: { x: 92, y: 18, lines: 3 }, narrow: { x: 92, y: 62, lines: 2 } } as const
const LINE_HEIGHT = 17
const WIDEST = 260

export class Readout {
  readonly root = svg('g', { class: 'readout' })
  readonly #jacdet = svg('text', { class: 'jacdet' })
  readonly #reference = svg('text')
  readonly #position = svg('text')

  constructor() {
    this.root.dataset.copies = 'point'
    this.root.append(this.#jacdet, this.#reference, this.#position)
    // Pressing the words is no tap on the scene, which would point elsewhere.
    this.root.addEventListener('pointerdown', event => event.stopPropagation())
  }

  update(probe: JacobianReport | null, cube: ReferenceCube, isNarrow: boolean): void {
    show(this.root, probe !== null)
    if (probe === null) return
    const { x, y } = isNarrow ? PLACES.narrow : PLACES.wide
    const lines = isNarrow ? [this.#jacdet, this.#position] : [this.#jacdet, this.#reference, this.#position]
    lines.forEach((line, i) => {
      set(line, { x, y: y + i * LINE_HEIGHT })
    })
    this.#jacdet.classList.toggle('negative', probe.jacdet < 0)
    const jacdet = formatJacdet(probe.jacdet, probe.exponent, cube)
    setText(this.#jacdet, `J${isNarrow ? formatPoint(probe.point) : ''} = ${jacdet}`)
    show(this.#reference, !isNarrow)
    setText(this.#reference, `(ξ, η, ζ) = ${formatPoint(probe.point)}`)
    setText(this.#position, `${isNarrow ? 'at' : '(x, y, z) ='} ${formatPoint(probe.position)}`)
  }
}

/** The room that it takes. */
export function readoutBox(isNarrow: boolean): Box {
  const { x, y, lines } = isNarrow ? PLACES.narrow : PLACES.wide
  return { x, y: y - LINE_HEIGHT / 2, width: WIDEST, height: lines * LINE_HEIGHT }
}

/** "Minimum, edge 4-7: jacdet -11.28. xi 0, eta 0, zeta 0.4196. x -1, y 2.2, z 0.1." */
export function spokenProbe(probe: JacobianReport, at: Candidate, isMinimum: boolean, cube: ReferenceCube): string {
  const place = at.kind === 'edge' ? `edge ${edgeName(at.id).replace('–', '-')}` : `${at.kind} ${at.id}`
  const name = isMinimum ? `Minimum, ${place}` : `Candidate, ${place}`
  const list = (names: readonly string[], values: readonly number[]) =>
    names.map((coordinate, i) => `${coordinate} ${speakNumber(values[i] as number)}`).join(', ')
  const jacdet = speakJacdet(probe.jacdet, probe.exponent, cube)
  return `${name}: jacdet ${jacdet}. ${list(['xi', 'eta', 'zeta'], probe.point)}. ${list(['x', 'y', 'z'], probe.position)}.`
}
