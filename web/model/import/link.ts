/** A link to an element, or its fragment alone. */
import { decodePermalink } from '../permalink'
import { type Format, Refused, readingOf } from './format'

export const link: Format = {
  name: 'a link',
  read(text) {
    const fragment = /\bv=\w+&vertices=\S*/.exec(text)?.[0]
    if (fragment === undefined) return null
    const result = decodePermalink(fragment)
    if (!result.ok) throw new Refused(result.error.message)
    return readingOf([{ name: 'the link’s element', vertices: result.value }])
  },
}
