/** A link to an element of this project's page, or its fragment alone. */
import { decodePermalink } from '../../model/permalink'
import { MeshBuilder } from '../mesh-builder'
import { headText, snippetText } from '../snippet-text'
import type { MeshFormat } from '../source'

const FRAGMENT = /\bv=\w{1,20}&vertices=[^\s>)\]"']*/
/** The longest link. */
const LONGEST = 65_536

export const link: MeshFormat = {
  name: 'link',
  recognizes: head => (head.length < LONGEST && FRAGMENT.test(headText(head)) ? 'yes' : 'no'),
  read(file) {
    const builder = new MeshBuilder('a link', file.name)
    const [fragment = ''] = FRAGMENT.exec(snippetText(file) ?? '') ?? []
    const result = decodePermalink(fragment)
    return result.ok ? [builder.meshOfOne(result.value)] : builder.refuse(result.error.message)
  },
}
