/** Elements as small pictures to choose from, and those that the reader keeps. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { repeat } from 'lit-html/directives/repeat.js'
import type { Vertices } from '../../model/hexahedron'
import { BLANK, type Pictures } from '../pictures'
import type { KeptElements } from './kept'

export interface Choice {
  readonly vertices: Vertices
  readonly name: string
  /** Under the picture. */
  readonly caption: string
}

export interface ChoicesProps {
  readonly label: string
  readonly choices: readonly Choice[]
  readonly pictures: Pictures
  readonly isShown: (vertices: Vertices) => boolean
  readonly onChoose: (choice: Choice) => void
  readonly onRemove?: (choice: Choice) => void
  /** Under the caption. */
  readonly actionsOf?: (choice: Choice) => TemplateResult
}

export function choicesTemplate({
  label,
  choices,
  pictures,
  isShown,
  onChoose,
  onRemove,
  actionsOf,
}: ChoicesProps): TemplateResult {
  return html`<ul class="choices-grid" aria-label=${label}>
    ${repeat(
      choices,
      ({ vertices }) => vertices.join(),
      choice => {
        const picture = pictures.of(choice.vertices)
        const { caption, name } = choice
        return html`<li>
          <button
            type="button"
            class="picture"
            aria-current=${isShown(choice.vertices) ? 'true' : nothing}
            @click=${() => onChoose(choice)}
          >
            <img src=${picture?.address ?? BLANK} alt=${picture ? `${picture.text}.` : 'An element.'} width="120" height="120" />
            <span>${caption}</span>
          </button>
          ${actionsOf?.(choice)}
          ${
            onRemove
              ? html`<button type="button" class="remove" aria-label=${`Remove ${name}`} @click=${() => onRemove(choice)}>×</button>`
              : nothing
          }
        </li>`
      },
    )}
  </ul>`
}

export interface KeptProps {
  readonly kept: KeptElements
  readonly choicesTemplate: (choices: readonly Choice[]) => TemplateResult
  onExport(): void
}

export function keptTemplate({ kept, choicesTemplate, onExport }: KeptProps): TemplateResult | typeof nothing {
  const { elements, persistence } = kept
  if (elements.length === 0 && persistence !== 'newer') return nothing
  return html`<section aria-labelledby="kept">
    <h2 id="kept">Kept</h2>
    ${STORAGE_NOTES[persistence] === '' ? nothing : html`<p class="quiet">${STORAGE_NOTES[persistence]}</p>`}
    ${choicesTemplate(elements.map(element => ({ ...element, caption: element.name })))}
    ${elements.length > 0 ? html`<button type="button" @click=${onExport}>Export what is kept</button>` : nothing}
  </section>`
}

const STORAGE_NOTES: Readonly<Record<KeptElements['persistence'], string>> = {
  stored: '',
  unavailable:
    'This browser stores nothing for this page. These elements are gone when the page is closed: export them to keep them.',
  newer:
    'A later version of this page has kept elements here. They stay as they are. What you keep now is gone when this page is closed.',
}
