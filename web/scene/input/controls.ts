/** The scene's few words and buttons: the legend of the marks, or a page's hint in its place, chips, the display of the faces, turning, fit, help. */
import type { Report } from '../../core/report'
import { faces } from '../../model/hexahedron'
import { type State, sliceOf } from '../../model/state'
import {
  CONTROLS,
  type Control,
  controlsSlice,
  type DragKeys,
  type FaceDisplay,
  sceneSlice,
} from '../../views/scene-slices'
import { type PlainWord, say } from '../../words/say'
import { candidateShapes } from '../overlay/candidate-shapes'
import { svg } from '../paint/svg'
import { Chips } from './chips'

export interface ControlActions {
  toggleHelp(): void
  fit(): void
  toggleReference(): void
  showMinimum(): void
  showFaces(faceDisplay: FaceDisplay): void
  hold(keys: DragKeys): void
  /** In steps to the right and up. */
  turn(right: number, up: number): void
  zoom(factor: number): void
}

/** One press at a time, for those who cannot drag or pinch. */
const TURNS: readonly (readonly [sign: string, name: PlainWord, act: (actions: ControlActions) => void])[] = [
  ['←', 'Turn left', actions => actions.turn(-1, 0)],
  ['→', 'Turn right', actions => actions.turn(1, 0)],
  ['↑', 'Turn up', actions => actions.turn(0, 1)],
  ['↓', 'Turn down', actions => actions.turn(0, -1)],
  ['+', 'Zoom in', actions => actions.zoom(1.2)],
  ['−', 'Zoom out', actions => actions.zoom(1 / 1.2)],
]

export class Controls {
  readonly root = document.createElement('div')
  readonly #faces = document.createElement('select')
  readonly #help: HTMLButtonElement
  readonly #reference: HTMLButtonElement
  readonly #buttons: Readonly<Record<Control, HTMLElement>>
  readonly #legend = document.createElement('p')
  /** The page's hint, which stands here until the first gesture. */
  readonly #hint = document.createElement('slot')
  readonly #chips: Chips
  readonly #kinds: Readonly<Record<'edge' | 'face', HTMLElement>> = {
    edge: legendEntry('edge', say('edge candidate')),
    face: legendEntry('face', say('face candidate')),
  }

  constructor(actions: ControlActions) {
    this.root.className = 'scene-controls'
    this.#hint.name = 'hint'
    this.#hint.append(this.#kinds.edge, this.#kinds.face)
    this.#hint.addEventListener('slotchange', () => {
      this.root.classList.toggle('hints', this.#hint.assignedElements().length > 0)
    })
    this.#legend.append(this.#hint)
    this.#chips = new Chips(keys => actions.hold(keys))
    this.#faces.append(
      option('opaque', say('All faces')),
      option('see-through', say('See-through')),
      option('inside', say('Inside')),
      ...faces.map((face, id) => option(String(id), say('Face {name} alone', { name: face.name }))),
    )
    this.#faces.setAttribute('aria-label', say('Faces shown'))
    this.#faces.addEventListener('change', () => {
      const { value } = this.#faces
      actions.showFaces(/^\d$/.test(value) ? Number(value) : (value as FaceDisplay))
    })
    const fit = button(say('Fit'), say('Bring the element into view (F)'), () => actions.fit())
    const turns = document.createElement('div')
    turns.className = 'turns'
    turns.id = 'scene-turns'
    turns.hidden = true
    turns.setAttribute('role', 'group')
    turns.setAttribute('aria-label', say('Turn and zoom'))
    for (const [sign, name, act] of TURNS) {
      const turn = button(sign, say(name), () => act(actions))
      turn.setAttribute('aria-label', say(name))
      turns.append(turn)
    }
    const turn = button(say('Turn'), say('Turn and zoom by pressing buttons'), () => {
      turns.hidden = !turns.hidden
      turn.setAttribute('aria-expanded', String(!turns.hidden))
    })
    turn.setAttribute('aria-expanded', 'false')
    turn.setAttribute('aria-controls', turns.id)
    const choice = document.createElement('span')
    choice.className = 'choice'
    choice.append(this.#faces)
    this.#help = button(say('Help'), say('What keys and pointers do (?)'), () => actions.toggleHelp())
    const minimum = button(say('Show the minimum'), say('Turn to where it is seen (M)'), () => actions.showMinimum())
    minimum.className = 'to-minimum'
    const beside = say('The same colours in (ξ, η, ζ), beside the element (R)')
    this.#reference = button(say('Reference cube'), beside, () => actions.toggleReference())
    this.#buttons = { minimum, faces: choice, reference: this.#reference, turn, fit, help: this.#help }
    this.root.append(
      this.#buttons.minimum,
      this.#legend,
      this.#chips.root,
      turns,
      ...CONTROLS.slice(1).map(control => this.#buttons[control]),
    )
  }

  update(state: State, report: Report | null): void {
    const { faceDisplay, referenceShown } = sliceOf(sceneSlice, state)
    const { controls, helpShown, byFinger, held } = sliceOf(controlsSlice, state)
    const hasChips = byFinger && state.isVertexChosen && !state.isReadonly
    this.#chips.update(held, hasChips)
    this.#legend.hidden = hasChips
    if (state.gestureStart !== null && this.#hint.isConnected) {
      this.#hint.replaceWith(...this.#hint.childNodes)
      this.root.classList.remove('hints')
    }
    for (const control of CONTROLS) this.#buttons[control].hidden = !controls.includes(control)
    this.#help.setAttribute('aria-expanded', String(helpShown))
    this.#reference.setAttribute('aria-pressed', String(referenceShown))
    const value = String(faceDisplay)
    if (this.#faces.value !== value) this.#faces.value = value
    for (const kind of ['edge', 'face'] as const) {
      this.#kinds[kind].hidden = !report?.candidates.some(candidate => candidate.kind === kind)
    }
  }
}

function button(text: string, title: string, onClick: () => void): HTMLButtonElement {
  const made = document.createElement('button')
  made.type = 'button'
  made.textContent = text
  made.title = title
  made.addEventListener('click', onClick)
  return made
}

function option(value: string, text: string): HTMLOptionElement {
  return new Option(text, value)
}

function legendEntry(kind: 'edge' | 'face', text: string): HTMLElement {
  const entry = document.createElement('span')
  const icon = svg('svg', { viewBox: '-6 -6 12 12', width: 12, height: 12, 'aria-hidden': 'true' })
  icon.append(svg('path', { class: 'candidate', d: candidateShapes[kind] }))
  entry.append(icon, text)
  return entry
}
