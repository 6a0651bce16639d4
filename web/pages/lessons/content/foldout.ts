/** A derivation that the reader opens: HTML, with formulas of mathml.ts. The summary is text. */
export function foldout(summary: string, text: string): string {
  return `<details class="foldout"><summary>${summary}</summary>${text}</details>`
}
