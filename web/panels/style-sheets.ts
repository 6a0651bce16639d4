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
  sheet.replaceSync(inOwnSize(styles))
  sheets.set(styles, sheet)
  return sheet
}

const REM = /(\d*\.?\d+)rem\b/g

/**
 * The size of a page's own text does not concern the element, unless the page says so: 1rem here is
 * `--hl-rem`, by default 16 pixels. Conditions cannot have variables.
 */
function inOwnSize(styles: string): string {
  return styles
    .replace(/@[^{]+\{/g, condition => condition.replace(REM, (_, number) => `${16 * Number(number)}px`))
    .replace(REM, 'calc($1 * var(--hl-rem, 16px))')
}
