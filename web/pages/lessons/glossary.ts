/** Words of the lessons that can be pointed at, and what each means in a sentence or two. */

export interface Term {
  /** Part of ids on the page. */
  readonly id: string
  readonly name: string
  /** Text. */
  readonly means: string
  /** The forms in which the texts have it; without capital letters. */
  readonly forms: readonly string[]
}

export const glossary: readonly Term[] = [
  {
    id: 'bernstein',
    name: 'Bernstein coefficient',
    means:
      'A polynomial of degree two on [0, 1] is a mean of three numbers with weights that are never negative. These numbers are its Bernstein coefficients. The polynomial is never below the least of them.',
    forms: ['bernstein coefficients', 'bernstein coefficient', 'bernstein form', 'bernstein bounds'],
  },
  {
    id: 'bilinear',
    name: 'bilinear',
    means: 'Linear in each of two coordinates while the other stays as it is.',
    forms: ['bilinear'],
  },
  {
    id: 'boundary',
    name: 'boundary',
    means: 'The six faces of the element together, with their edges and vertices.',
    forms: ['boundary'],
  },
  {
    id: 'candidate',
    name: 'candidate',
    means: 'A point of the boundary at which jacdet may be least: a vertex, a point of an edge or a point of a face.',
    forms: ['candidates', 'candidate'],
  },
  {
    id: 'gauss-points',
    name: 'Gauss points',
    means: 'The points inside an element at which a solver evaluates its integrals. Often there are 2 × 2 × 2 of them.',
    forms: ['gauss points'],
  },
  {
    id: 'jacdet',
    name: 'jacdet',
    means:
      'The Jacobian determinant, J for short: the factor by which the map changes the volume of a tiny box. Negative if the box is turned inside out.',
    forms: ['jacobian determinant', 'jacdet'],
  },
  {
    id: 'jacobian-matrix',
    name: 'Jacobian matrix',
    means:
      'Its columns are the derivatives of the map by each reference coordinate: the sides of the image of a tiny box.',
    forms: ['jacobian matrix'],
  },
  {
    id: 'quartic',
    name: 'quartic',
    means: 'A polynomial of degree four. It has at most four roots.',
    forms: ['quartic'],
  },
  {
    id: 'reference-coordinates',
    name: 'reference coordinates',
    means: 'The coordinates ξ, η and ζ of a point before it is mapped. Each goes from 0 to 1.',
    forms: ['reference coordinates', 'reference coordinate'],
  },
  {
    id: 'reference-cube',
    name: 'reference cube',
    means: 'The unit cube that is mapped to the element. Each point of the element comes from a point of it.',
    forms: ['reference cube'],
  },
  {
    id: 'saddle',
    name: 'saddle',
    means: 'A point from which a function rises in one direction and falls in another.',
    forms: ['saddles', 'saddle'],
  },
  {
    id: 'scaled-jacobian',
    name: 'scaled Jacobian',
    means: 'jacdet divided by the lengths of the three columns. It is at most 1, and 1 where they are at right angles.',
    forms: ['scaled jacobian'],
  },
  {
    id: 'trilinear',
    name: 'trilinear',
    means: 'Linear in each of three coordinates while the other two stay as they are.',
    forms: ['trilinear'],
  },
]

const byForm = new Map(glossary.flatMap(term => term.forms.map(form => [form, term] as const)))
/** Longer forms first: "Jacobian determinant" is one. */
const forms = [...byForm.keys()].sort((a, b) => b.length - a.length)
/** And the punctuation mark behind. */
const FORMS = new RegExp(`(?<![\\p{L}-])(${forms.join('|').replaceAll(' ', '\\s+')})(?![\\p{L}-])([.,:;?!]?)`, 'giu')

/** The id of the element with a term's meaning, which buttons refer to. */
export const meaningId = ({ id }: Term): string => `meaning-${id}`

export function termOf(id: string): Term | null {
  return glossary.find(term => term.id === id) ?? null
}

/** The HTML with the first of each term's words as a button; formulas, links and buttons are left alone. */
export function withTerms(html: string): string {
  const marked = new Set<Term>()
  return html
    .split(/(<(math|a|button)\b[\s\S]*?<\/\2>|<[^>]*>)/)
    .filter((_, i) => i % 3 !== 2)
    .map((part, i) =>
      i % 2 === 1
        ? part
        : part.replace(FORMS, (_, words: string, mark: string) => {
            const term = byForm.get(words.toLowerCase().replace(/\s+/g, ' ')) as Term
            if (marked.has(term)) return words + mark
            marked.add(term)
            const button = `<button type="button" class="term" data-term="${term.id}" aria-describedby="${meaningId(term)}">${words}</button>`
            return mark === '' ? button : `<span class="kept">${button}${mark}</span>`
          }),
    )
    .join('')
}
