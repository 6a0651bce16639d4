/** The numbers at the probe: as words on the screen, and as a sentence to be heard. */
import type { Candidate, JacobianReport } from '../../core/report'
import { formatJacdet, formatPoint, speakJacdet, speakNumber } from '../../model/decimal'
import { edgeName } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import type { Frame } from '../../views/view'
import { say } from '../../words/say'
import { set, setText, show, svg } from '../paint/svg'
import { type PaneLayout, READOUT_LINE } from '../space/layout'
import { samePoint } from '../space/vec3'

export class Readout {
  readonly root = svg('g', { class: 'readout' })
  readonly #jacdet = svg('text', { class: 'jacdet' })
  readonly #reference = svg('text')
  readonly #position = svg('text')

  constructor() {
    this.root.dataset.copies = 'point'
    this.root.append(this.#jacdet, this.#reference, this.#position)
    // A press on the words is no tap on the scene, which would mark another point.
    this.root.addEventListener('pointerdown', event => event.stopPropagation())
  }

  update(probe: JacobianReport | null, cube: ReferenceCube, { isNarrow, readout }: PaneLayout): void {
    show(this.root, probe !== null)
    if (probe === null) return
    const lines = isNarrow ? [this.#jacdet, this.#position] : [this.#jacdet, this.#reference, this.#position]
    lines.forEach((line, i) => {
      set(line, { x: readout.x, y: readout.y + (i + 0.5) * READOUT_LINE })
    })
    this.#jacdet.classList.toggle('negative', probe.jacdet < 0)
    const jacdet = formatJacdet(probe.jacdet, probe.exponent, cube)
    const box = boxWords(probe)
    setText(this.#jacdet, isNarrow ? `J${formatPoint(probe.point)} = ${jacdet}` : `J = ${jacdet}${box && `: ${box}`}`)
    show(this.#reference, !isNarrow)
    setText(this.#reference, `(ξ, η, ζ) = ${formatPoint(probe.point)}`)
    const point = formatPoint(probe.position)
    const place = box === '' ? say('at {point}', { point }) : say('{box} at {point}', { box, point })
    setText(this.#position, isNarrow ? place : `(x, y, z) = ${point}`)
  }
}

/** What becomes of the little cube if it does not only change its shape. */
function boxWords({ jacdet }: JacobianReport): string {
  return jacdet > 0 ? '' : jacdet < 0 ? say('inside out') : say('flat')
}

/** The candidate that a key has marked, to be heard. */
export class SpokenProbe {
  readonly root = document.createElement('p')
  #next: Candidate | null = null

  constructor() {
    this.root.className = 'scene-said said'
    this.root.setAttribute('aria-live', 'polite')
  }

  /** Says it in the next frame. */
  announce(candidate: Candidate): void {
    this.#next = candidate
  }

  update({ state, probe, report }: Frame): void {
    const next = this.#next
    this.#next = null
    if (probe === null) this.root.textContent = ''
    else if (next !== null && report) {
      this.root.textContent = spokenProbe(
        probe,
        next,
        samePoint(next.point, report.minimizer.point),
        state.referenceCube,
      )
    }
  }
}

/** "Minimum, edge 4-7: jacdet -11.28, inside out. xi 0, eta 0, zeta 0.4196. x -1, y 2.2, z 0.1." */
function spokenProbe(probe: JacobianReport, at: Candidate, isMinimum: boolean, cube: ReferenceCube): string {
  const part =
    at.kind === 'edge'
      ? say('edge {name}', { name: edgeName(at.id).replace('–', '-') })
      : at.kind === 'vertex'
        ? say('vertex {name}', { name: at.id })
        : say('face {name}', { name: at.id })
  const list = (names: readonly string[], values: readonly number[]) =>
    names.map((coordinate, i) => `${coordinate} ${speakNumber(values[i] as number)}`).join(', ')
  const jacdet = speakJacdet(probe.jacdet, probe.exponent, cube)
  const box = boxWords(probe)
  const values = {
    part,
    jacdet: box ? `${jacdet}, ${box}` : jacdet,
    point: list(['xi', 'eta', 'zeta'], probe.point),
    position: list(['x', 'y', 'z'], probe.position),
  }
  return isMinimum
    ? say('Minimum, {part}: jacdet {jacdet}. {point}. {position}.', values)
    : say('Candidate, {part}: jacdet {jacdet}. {point}. {position}.', values)
}
