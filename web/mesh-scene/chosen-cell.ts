/** The edges of the chosen cell, and of its neighbours as thin lines, as paths: in SVG over the picture, on a canvas in its PNG. */
import { edgeVertices, type Vertices } from '../model/hexahedron'
import { cssColour, type Theme } from '../scene/paint/colour-map'
import type { Point } from '../scene/space/layout'
import type { Neighbour } from '../survey/survey-jobs'

type Kind = 'neighbour' | 'neighbour invalid' | 'halo' | 'chosen'

export interface Outline {
  /** As style sheets call it, too. */
  readonly kind: Kind
  readonly path: string
}

/** The later ones lie over the others. */
export function outlinesOf(
  chosen: Vertices | null,
  neighbours: readonly Neighbour[],
  project: (vertices: Vertices) => readonly (Point & { readonly depth: number })[],
): Outline[] {
  if (!chosen) return []
  const pathOf = (vertices: Vertices) => {
    const points = project(vertices)
    return edgeVertices
      .map(([from, to]) => [points[from], points[to]])
      .filter(([a, b]) => a && b && a.depth > 0 && b.depth > 0)
      .map(([a, b]) => `M${a?.x.toFixed(1)} ${a?.y.toFixed(1)}L${b?.x.toFixed(1)} ${b?.y.toFixed(1)}`)
      .join('')
  }
  const own = pathOf(chosen)
  return [
    ...neighbours.map(({ isInvalid, vertices }): Outline => {
      return { kind: isInvalid ? 'neighbour invalid' : 'neighbour', path: pathOf(vertices) }
    }),
    { kind: 'halo', path: own },
    { kind: 'chosen', path: own },
  ]
}

/** Width in CSS pixels, and opacity, as the style sheets have them. */
const STROKES: Readonly<Record<Kind, readonly [width: number, opacity: number]>> = {
  neighbour: [0.75, 0.6],
  'neighbour invalid': [0.75, 1],
  halo: [5, 0.8],
  chosen: [2, 1],
}

export function strokeOutlines(
  context: OffscreenCanvasRenderingContext2D,
  outlines: readonly Outline[],
  { paper, ink, negative }: Theme,
): void {
  context.save()
  context.lineCap = 'round'
  for (const { kind, path } of outlines) {
    const [width, opacity] = STROKES[kind]
    context.lineWidth = width
    context.globalAlpha = opacity
    context.strokeStyle = cssColour(kind === 'halo' ? paper : kind === 'neighbour invalid' ? negative : ink)
    context.stroke(new Path2D(path))
  }
  context.restore()
}
