/** The sentence on top: "12 of 88,432 hexahedra are invalid." stands out. */
import { html, type TemplateResult } from 'lit-html'

export function headlineTemplate(headline: string): TemplateResult {
  const [first, ...others] = headline.split(/(?<=\.) /)
  return html`<strong>${first}</strong> ${others.join(' ')}`
}
