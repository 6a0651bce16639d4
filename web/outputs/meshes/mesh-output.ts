/** `--annotate`: the checked mesh in the format that the name of its file ends in. */
import type { Output } from '../output'
import { MESH_FORMS } from './list'
import type { MeshForm } from './mesh-form'
import { wholeMesh } from './mesh-part'

/** ".vtu, .vtk, ..." */
export const MESH_ENDINGS = MESH_FORMS.map(({ id }) => `.${id}`).join(', ')

/** The first of the list for a name without an ending, such as a pipe's; null for another ending. */
export function meshFormOf(path: string): MeshForm | null {
  const ending = /[^\\/.]\.([^\\/.]*)$/.exec(path)?.[1]
  return ending === undefined ? MESH_FORMS[0] : (MESH_FORMS.find(({ id }) => id === ending.toLowerCase()) ?? null)
}

/** `say` gets sentences for people. */
export function meshOutput(form: MeshForm, say: (sentence: string) => void): Output {
  return {
    lists: { minima: true, volumes: true },
    *file(result) {
      if ('check' in result) yield* form.chunks(wholeMesh(result.check), say)
    },
    *end() {},
  }
}
