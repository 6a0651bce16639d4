/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { gmsh } from './formats/gmsh'
import { medit } from './formats/medit'
import { mfem } from './formats/mfem'
import type { MeshFormat } from './source'

export const formats: readonly MeshFormat[] = [gmsh, medit, mfem]
