/** A PNG that was taken away from this project's page: the link to its element is inside. */
import { decodePermalink } from '../../model/permalink'
import { isPng, PNG_KEYWORD, textOf } from '../../model/png-text'
import { MeshBuilder } from '../mesh-builder'
import type { MeshFormat } from '../source'

export const picture: MeshFormat = {
  name: 'picture',
  recognizes: head => (isPng(head) ? 'yes' : 'no'),
  read(file) {
    const builder = new MeshBuilder('a picture from here', file.name)
    const fragment = textOf(file.read(0, file.size), PNG_KEYWORD)
    if (fragment === null)
      return builder.refuse('this PNG has no element in it; those that are taken away from here have.')
    const link = decodePermalink(fragment)
    return link.ok ? [builder.meshOfOne(link.value)] : builder.refuse(link.error.message)
  },
}
