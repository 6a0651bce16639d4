/** Numbers as papers, spreadsheets and formulas have them, in the form that programs print. */

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻'
const POWER = /(\d)[ \t]?(?:[×x·*]|\\times|\\cdot)[ \t]?10(?:\^\{?([-−+]?\d{1,4})\}?|([⁰¹²³⁴-⁹⁺⁻]{1,5}))/g
/** Eight nodes with hyphens between them, or on a line each under a title. */
const APART =
  /(?<![\w.-])\d{1,9}(?:-\d{1,9}){7}(?![\w.-])|(?<=(?:conn|elem|cell|hex)[^\n\d]{0,30}\n)(?:\d{1,9}\n){7}\d{1,9}(?=\n|$)/gi
/** In these languages 1/2 is 0. */
const DIVIDES_INTEGERS = /\b(?:double|float|real|f64|std|Eigen)\b/i

/** LaTeX's \num{0.5} and 0{,}5; 1.5×10⁻³ and 1.5*10^-3; 1/2; the numbers of a list, "1. ", which are no decimals; nodes
 * of a cell that stand apart. */
export function withPlainNumbers(text: string): string {
  const plain = text
    .replace(/\\num\{([^{}\n]{1,60})\}/g, '$1')
    .replace(/(\d)\{,\}(?=\d)/g, '$1,')
    .replace(APART, nodes => nodes.replace(/[-\n]/g, ' '))
    .replace(POWER, (_, digit, power, raised) => `${digit}e${power?.replace('−', '-') ?? lowered(raised)}`)
    .replace(/^([ \t]*\d{1,3})\.(?=[ \t][^\n]*[,;(])/gm, '$1 ')
  if (DIVIDES_INTEGERS.test(text)) return plain
  return plain.replace(/(?<![\w./])(-?\d{1,9})\/([1-9]\d{0,8})(?![\w./])/g, (_, above, below) => String(above / below))
}

function lowered(raised: string): string {
  return Array.from(raised, mark => '0123456789+-'[SUPERSCRIPTS.indexOf(mark)]).join('')
}
