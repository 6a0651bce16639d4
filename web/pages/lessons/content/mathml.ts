/** Formulas as MathML: numbers, names of one or more letters and signs are told apart by what they are. */

/** A term that is MathML already. */
interface Markup {
  readonly markup: string
}

/** "J", "det", "ξ" are identifiers, 2 and "1.5" numbers, all else operators. */
export type Term = string | number | Markup

/** A formula in a line of text. */
export function math(...terms: readonly Term[]): string {
  return `<math>${joined(terms)}</math>`
}

/** A formula on a line of its own. */
export function display(...terms: readonly Term[]): string {
  return `<math display="block">${joined(terms)}</math>`
}

export function row(...terms: readonly Term[]): Markup {
  return { markup: `<mrow>${joined(terms)}</mrow>` }
}

/** Words between formulas. */
export function words(text: string): Markup {
  return { markup: `<mtext>\u00a0${text}\u00a0</mtext>` }
}

/** Terms in parentheses. */
export function of(...terms: readonly Term[]): Markup {
  return row('(', ...terms, ')')
}

/** Terms in square brackets or parentheses as high as they are. */
export function tall(open: '(' | '[', ...terms: readonly Term[]): Markup {
  return row({ markup: `<mo>${open}</mo>` }, ...terms, { markup: `<mo>${open === '(' ? ')' : ']'}</mo>` })
}

export function sub(base: Term, below: Term): Markup {
  return element('msub', base, below)
}

export function sup(base: Term, above: Term): Markup {
  return element('msup', base, above)
}

/** The derivative of a function of one variable. The sign stands as high as it should by itself. */
export function prime(base: Term): Markup {
  return row(base, { markup: '<mo lspace="0" rspace="0">′</mo>' })
}

export function subsup(base: Term, below: Term, above: Term): Markup {
  return element('msubsup', base, below, above)
}

export function frac(numerator: Term, denominator: Term): Markup {
  return element('mfrac', numerator, denominator)
}

/** A space as before and behind the name of a function. */
export const thin: Markup = { markup: '<mspace width="0.17em"></mspace>' }

/** The determinant of what follows. */
export function det(...terms: readonly Term[]): Markup {
  return row('det', thin, ...terms)
}

/** A matrix in square brackets, row by row. */
export function matrix(...rows: readonly (readonly Term[])[]): Markup {
  const cells = rows.map(line => `<mtr>${line.map(term => `<mtd>${markupOf(term)}</mtd>`).join('')}</mtr>`)
  return tall('[', { markup: `<mtable>${cells.join('')}</mtable>` })
}

function element(name: string, ...terms: readonly Term[]): Markup {
  return { markup: `<${name}>${terms.map(markupOf).join('')}</${name}>` }
}

function joined(terms: readonly Term[]): string {
  return terms
    .map((term, i) => (term === '−' && isOperator(terms[i - 1]) ? '<mo form="prefix">−</mo>' : markupOf(term)))
    .join('')
}

/** True if a minus after it is a number's sign, and stands close to the number. */
function isOperator(term: Term | undefined): boolean {
  return typeof term === 'string' && /^[=<>≤≥,·+(]$/.test(term)
}

function markupOf(term: Term): string {
  if (typeof term === 'object') return term.markup
  const text = String(term)
  if (/^[\d.]+$/.test(text)) return `<mn>${text}</mn>`
  if (/^\p{L}+$/u.test(text)) return `<mi>${text}</mi>`
  if (/^[()[\]|]$/.test(text)) return `<mo stretchy="false">${text}</mo>`
  return `<mo>${text.replace('<', '&lt;').replace('>', '&gt;')}</mo>`
}
