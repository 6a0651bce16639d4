/** Style sheets that all elements on the page share, made when the first of them needs them: servers have none. */

const sheets = new Map<string, CSSStyleSheet>()

/** Adds the styles after those that are there, once. */
export function adoptStyles(shadow: ShadowRoot, styles: readonly string[]): void {
  const missing = styles.map(sheetOf).filter(sheet => !shadow.adoptedStyleSheets.includes(sheet))
  if (missing.length > 0) shadow.adoptedStyleSheets = [...shadow.adoptedStyleSheets, ...missing]
}

function sheetOf(styles: string): CSSStyleSheet {
  const known = sheets.get(styles)
  if (known) return known
  const sheet = new CSSStyleSheet()
  sheet.replaceSync(inPixels(styles))
  sheets.set(styles, sheet)
  return sheet
}

/** How large a page's own text is does not concern the element: 1rem here are 16 pixels. */
function inPixels(styles: string): string {
  return styles.replace(/(\d*\.?\d+)rem\b/g, (_, number) => `${16 * Number(number)}px`)
}
