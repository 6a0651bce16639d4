/** Style sheets that all elements on the page share, made for the first: servers have none. */

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
  sheet.replaceSync(styles)
  sheets.set(styles, sheet)
  return sheet
}
