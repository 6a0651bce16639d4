/** Elements as small pictures to choose from. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { repeat } from 'lit-html/directives/repeat.js'
import type { Vertices } from '../../model/hexahedron'
import { BLANK, type Pictures } from '../pictures'

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
}

export function choicesTemplate({
  label,
  choices,
  pictures,
  isShown,
  onChoose,
  onRemove,
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
