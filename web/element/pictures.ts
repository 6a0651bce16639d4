/** The element's pictures as files; loaded when the first is asked for. */

import type { Vertices } from '../model/hexahedron'
import { encodePermalink } from '../model/permalink'
import { PNG_KEYWORD, withText } from '../model/png-text'
import { figurePng, figureSvg } from '../panels/take-away/figure-files'
import type { Figure } from '../views/view'

/** With the vertices inside: dropped on an element it opens them. */
export async function pngOf(figure: Figure, vertices: Vertices): Promise<Blob> {
  const picture = withText(await figurePng(figure), PNG_KEYWORD, encodePermalink(vertices))
  return new Blob([picture], { type: 'image/png' })
}

export function svgOf(figure: Figure, vertices: Vertices, title: string): string {
  return figureSvg(figure, title, encodePermalink(vertices))
}
