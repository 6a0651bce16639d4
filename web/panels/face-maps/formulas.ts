/** The selected face's polynomials, as MathML; a formula is several elements, so that it wraps. */
import { html, mathml, type TemplateResult } from 'lit-html'
import { type FacePolynomials, powerCoefficients } from '../../core/face-polynomials'
import type { FaceReport } from '../../core/report'
import { asDouble, formatJacdet, formatNumber } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { say } from '../../words/say'

type Fragment = TemplateResult | string

/** Powers of two between the two reference cubes, for what is of degree 1 in jacdet. */
const CUBE_SHIFT: Readonly<Record<ReferenceCube, number>> = { unit: 0, biunit: -3 }

/** value * 2^exponent of degree `degree` in jacdet, in decimals. */
export function decimalText(value: number, exponent: number, degree: number, cube: ReferenceCube): string {
  const power = exponent + degree * CUBE_SHIFT[cube]
  const double = asDouble(value, power)
  return double === null ? formatJacdet(value, power, 'unit') : formatNumber(double)
}

export function formulas(
  face: FaceReport,
  { a, b, c, exponent: scaling }: FacePolynomials,
  reportExponent: number,
  cube: ReferenceCube,
): TemplateResult {
  const exponent = scaling + reportExponent
  const inJacdet = (bernstein: readonly number[]) => polynomial(bernstein, exponent, 1, cube)
  const quartic = face.quarticIsZero ? [zero] : polynomial(face.quartic, face.quarticExponent, 3, cube)
  return html`<div class="formulas">
    ${line([f, mathml`${equals}${of('a')}${squared(mathml`<mi>s</mi>`)}`, mathml`${plus}${of('b')}<mi>s</mi>`, mathml`${plus}${of('c')}`])}
    ${line([mathml`${of('a')}${equals}`, ...inJacdet(a)])}
    ${line([mathml`${of('b')}${equals}`, ...inJacdet(b)])}
    ${line([mathml`${of('c')}${equals}`, ...inJacdet(c)])}
    ${line([P, ...pDefinition])}
    ${line([mathml`${P}${equals}`, ...quartic])}
    ${line([D, mathml`${equals}<mn>4</mn><mi>a</mi><mi>c</mi>`, mathml`${minus}${squared(mathml`<mi>b</mi>`)}`, mathml`<mo>,</mo>`, mathml`<msup><mi>s</mi><mo>*</mo></msup><mo>=</mo><mo>−</mo><mi>b</mi><mo>/</mo><mo stretchy="false">(</mo><mn>2</mn><mi>a</mi><mo stretchy="false">)</mo>`])}
  </div>
  <p class="note">${say('These coefficients are rounded to be read; the core keeps P in Bernstein form.')}</p>`
}

// Each begins an element, where a sign has no room of its own.
const plus = mathml`<mo lspace="0" rspace="0.25em">+</mo>`
const minus = mathml`<mo lspace="0" rspace="0.25em">−</mo>`
const equals = mathml`<mo lspace="0.15em" rspace="0.25em">=</mo>`
const of = (name: string) => mathml`<mi>${name}</mi><mo stretchy="false">(</mo><mi>t</mi><mo stretchy="false">)</mo>`
const squared = (base: Fragment) => mathml`<msup><mrow>${base}</mrow><mn>2</mn></msup>`
// The sign is raised by itself; raised once more it would be a speck.
const prime = (name: string) => mathml`<mrow><mi>${name}</mi><mo lspace="0" rspace="0">′</mo></mrow>`
const zero = mathml`<mn>0</mn>`
const f = mathml`<mi>f</mi><mo stretchy="false">(</mo><mi>s</mi><mo>,</mo><mi>t</mi><mo stretchy="false">)</mo>`
const P = of('P')
const D = of('D')
const pDefinition = [
  mathml`${equals}<mn>4</mn>${squared(mathml`<mi>a</mi>`)}${prime('c')}`,
  mathml`${minus}<mn>2</mn><mi>a</mi><mi>b</mi>${prime('b')}`,
  mathml`${plus}${prime('a')}${squared(mathml`<mi>b</mi>`)}`,
]

function line(parts: readonly TemplateResult[]): TemplateResult {
  return html`<p>${parts.map(part => html`<math>${part}</math> `)}</p>`
}

/** The change to powers of t rounds by at most 2^4 * 6 times the largest coefficient's rounding. */
const LEAST_TERM = 2 ** -46

/** The terms in powers of t, without those that are nothing but rounding. */
function polynomial(
  bernstein: readonly number[],
  exponent: number,
  degree: number,
  cube: ReferenceCube,
): TemplateResult[] {
  const least = LEAST_TERM * Math.max(...bernstein.map(Math.abs))
  const terms = powerCoefficients(bernstein).flatMap((coefficient, power) =>
    Math.abs(coefficient) <= least ? [] : [{ coefficient, power }],
  )
  if (terms.length === 0) return [zero]
  return terms.map(({ coefficient, power }, i) => {
    const sign = i > 0 ? (coefficient < 0 ? minus : plus) : coefficient < 0 ? mathml`<mo>−</mo>` : ''
    const size = decimalText(Math.abs(coefficient), exponent, degree, cube)
    return mathml`${sign}<mn>${size}</mn>${powerOfT(power)}`
  })
}

function powerOfT(power: number): Fragment {
  if (power === 0) return ''
  return power === 1 ? mathml`<mi>t</mi>` : mathml`<msup><mi>t</mi><mn>${power}</mn></msup>`
}
