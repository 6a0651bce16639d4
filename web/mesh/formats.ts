/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { abaqus } from './formats/abaqus'
import { ansysCdb } from './formats/ansys-cdb'
import { gmsh } from './formats/gmsh'
import { lsDyna } from './formats/ls-dyna'
import { medit } from './formats/medit'
import { mfem } from './formats/mfem'
import { nastran } from './formats/nastran'
import { text } from './formats/text'
import { vtkLegacy } from './formats/vtk-legacy'
import { vtu } from './formats/vtu'
import type { MeshFormat } from './source'

export const formats: readonly MeshFormat[] = [
  vtu,
  vtkLegacy,
  gmsh,
  medit,
  mfem,
  abaqus,
  nastran,
  ansysCdb,
  lsDyna,
  text,
]
