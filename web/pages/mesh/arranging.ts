/** What the page says while the list is put into an order that takes longer. */
import { html, type TemplateResult } from 'lit-html'
import type { Arrangement } from '../../survey/survey-jobs'

export interface Arranging {
  readonly order: Arrangement
  /** Which part is done, from 0 to 1. */
  readonly fraction: number
}

export function arrangingTemplate({ fraction }: Arranging, onCancel: () => void): TemplateResult {
  return html`<p class="arranging">
    <label>Asking which checks accept each cell <progress max="1" .value=${fraction}></progress></label>
    <button type="button" @click=${onCancel}>Cancel</button>
  </p>`
}
