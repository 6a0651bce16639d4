/** The element of docs/embedding.md: nine-point and Gauss-point checks accept it, and it is invalid. */

import { encodePermalink } from '../../web/model/permalink'
import type { Embed } from '../../web/panels/embed/embed-lines'

const vertices = [0, 1, 0, 1, 1, -4, 1, 4, -3, -2, -1, -2, -4, 1, 4, 4, -1, 4, 4, 1, 3, -2, 3, 1]

export const documented: Embed = {
  vertices,
  views: ['scene', 'verdict', 'checks'],
  theme: 'auto',
  readonly: false,
  camera: null,
  height: 560,
  label: 'A hexahedron that nine-point checks accept and that is invalid',
  link: `https://example.org/hexlens/#${encodePermalink(vertices)}`,
  poster: 'hexlens.png',
}
