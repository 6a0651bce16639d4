/** A PNG that was taken away from this project's page: the link to its element is inside, before the image. */
import { decodePermalink } from '../../model/permalink'
import { PNG_KEYWORD, textOf } from '../../model/png-text'
import { MeshBuilder } from '../mesh-builder'
import type { MeshFormat } from '../source'

export const picture: MeshFormat = {
  name: 'picture',
  recognizes: head => (textOf(head, PNG_KEYWORD) === null ? 'no' : 'yes'),
  read(file) {
    const builder = new MeshBuilder('a picture from here', file.name)
    const link = decodePermalink(textOf(file.read(0, file.size), PNG_KEYWORD) ?? '')
    return link.ok ? [builder.meshOfOne(link.value)] : builder.refuse(link.error.message)
  },
}
