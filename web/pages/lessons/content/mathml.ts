/** Formulas as MathML: numbers, names of one or more letters and signs are told apart by what they are. */

/** A piece that is MathML already. */
interface Markup {
  readonly markup: string
}

/** "J", "det", "ξ" are identifiers, 2 and "1.5" numbers, all else operators. */
export type Piece = string | number | Markup

/** In a line of text. */
export function math(...pieces: readonly Piece[]): string {
  return `<math>${joined(pieces)}</math>`
}

/** On a line of its own. */
export function display(...pieces: readonly Piece[]): string {
  return `<math display="block">${joined(pieces)}</math>`
}

export function row(...pieces: readonly Piece[]): Markup {
  return { markup: `<mrow>${joined(pieces)}</mrow>` }
}

/** Words between formulas. */
export function words(text: string): Markup {
  return { markup: `<mtext>\u00a0${text}\u00a0</mtext>` }
}

/** In parentheses. */
export function of(...pieces: readonly Piece[]): Markup {
  return row('(', ...pieces, ')')
}

/** In square brackets or parentheses as high as what is in them. */
export function tall(open: '(' | '[', ...pieces: readonly Piece[]): Markup {
  return row({ markup: `<mo>${open}</mo>` }, ...pieces, { markup: `<mo>${open === '(' ? ')' : ']'}</mo>` })
}

export function sub(base: Piece, below: Piece): Markup {
  return element('msub', base, below)
}

export function sup(base: Piece, above: Piece): Markup {
  return element('msup', base, above)
}

/** The derivative of a function of one variable. */
export function prime(base: Piece): Markup {
  return sup(base, '′')
}

export function subsup(base: Piece, below: Piece, above: Piece): Markup {
  return element('msubsup', base, below, above)
}

export function frac(numerator: Piece, denominator: Piece): Markup {
  return element('mfrac', numerator, denominator)
}

/** The determinant of what follows. */
export function det(...pieces: readonly Piece[]): Markup {
  return row('det', { markup: '<mspace width="0.17em"></mspace>' }, ...pieces)
}

/** In square brackets, row by row. */
export function matrix(...rows: readonly (readonly Piece[])[]): Markup {
  const cells = rows.map(line => `<mtr>${line.map(piece => `<mtd>${markupOf(piece)}</mtd>`).join('')}</mtr>`)
  return tall('[', { markup: `<mtable>${cells.join('')}</mtable>` })
}

function element(name: string, ...pieces: readonly Piece[]): Markup {
  return { markup: `<${name}>${pieces.map(markupOf).join('')}</${name}>` }
}

function joined(pieces: readonly Piece[]): string {
  return pieces
    .map((piece, i) => (piece === '−' && isOperator(pieces[i - 1]) ? '<mo form="prefix">−</mo>' : markupOf(piece)))
    .join('')
}

/** After it a minus is a number's sign, and stands close to it. */
function isOperator(piece: Piece | undefined): boolean {
  return typeof piece === 'string' && /^[=<>≤≥,·+(]$/.test(piece)
}

function markupOf(piece: Piece): string {
  if (typeof piece === 'object') return piece.markup
  const text = String(piece)
  if (/^[\d.]+$/.test(text)) return `<mn>${text}</mn>`
  if (/^\p{L}+$/u.test(text)) return `<mi>${text}</mi>`
  if (/^[()[\]|]$/.test(text)) return `<mo stretchy="false">${text}</mo>`
  return `<mo>${text.replace('<', '&lt;').replace('>', '&gt;')}</mo>`
}
