/** The scene's few words and buttons: what the marks mean, how the faces are drawn, fit, help. */
import type { Report } from '../../core/report'
import { faces } from '../../model/hexahedron'
import type { FaceDisplay, State } from '../../model/state'
import { candidateShapes } from '../candidate-shapes'
import { svg } from '../svg'

export interface ControlActions {
  toggleHelp(): void
  fit(): void
  toggleReference(): void
  showFaces(faceDisplay: FaceDisplay): void
}

export class Controls {
  readonly root = document.createElement('div')
  readonly #faces = document.createElement('select')
  readonly #help = document.createElement('button')
  readonly #reference = document.createElement('button')
  readonly #fit = document.createElement('button')
  readonly #choice = document.createElement('span')
  readonly #legend = document.createElement('p')
  readonly #kinds: Readonly<Record<'edge' | 'face', HTMLElement>> = {
    edge: legendEntry('edge', 'edge candidate'),
    face: legendEntry('face', 'face candidate'),
  }

  constructor(actions: ControlActions) {
    this.root.className = 'scene-controls'
    this.#legend.append(this.#kinds.edge, this.#kinds.face)
    this.#faces.append(
      option('opaque', 'All faces'),
      option('see-through', 'See-through'),
      option('inside', 'Inside'),
      ...faces.map((face, id) => option(String(id), `Face ${face.name} alone`)),
    )
    this.#faces.setAttribute('aria-label', 'Faces shown')
    this.#faces.addEventListener('change', () => {
      const { value } = this.#faces
      actions.showFaces(/^\d$/.test(value) ? Number(value) : (value as FaceDisplay))
    })
    this.#fit.type = 'button'
    this.#fit.textContent = 'Fit'
    this.#fit.title = 'Bring the element into view (F)'
    this.#fit.addEventListener('click', () => actions.fit())
    this.#choice.className = 'choice'
    this.#choice.append(this.#faces)
    this.#help.type = 'button'
    this.#help.textContent = 'Help'
    this.#help.title = 'What keys and pointers do (?)'
    this.#help.addEventListener('click', () => actions.toggleHelp())
    this.showHelp(false)
    this.#reference.type = 'button'
    this.#reference.textContent = 'Reference cube'
    this.#reference.title = 'The same colours in (ξ, η, ζ), beside the element (R)'
    this.#reference.addEventListener('click', () => actions.toggleReference())
    this.root.append(this.#legend, this.#choice, this.#reference, this.#fit, this.#help)
  }

  /** Whether the help is on the screen. */
  showHelp(shown: boolean): void {
    this.#help.setAttribute('aria-expanded', String(shown))
  }

  update({ faceDisplay, referenceShown, controls }: State, report: Report | null): void {
    this.#choice.hidden = !controls.includes('faces')
    this.#reference.hidden = !controls.includes('reference')
    this.#fit.hidden = !controls.includes('fit')
    this.#help.hidden = !controls.includes('help')
    this.#reference.setAttribute('aria-pressed', String(referenceShown))
    const value = String(faceDisplay)
    if (this.#faces.value !== value) this.#faces.value = value
    for (const kind of ['edge', 'face'] as const) {
      this.#kinds[kind].hidden = !report?.candidates.some(candidate => candidate.kind === kind)
    }
  }
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
