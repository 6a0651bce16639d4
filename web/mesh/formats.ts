/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { abaqus } from './formats/abaqus'
import { ansysCdb } from './formats/ansys-cdb'
import { blockMeshDict } from './formats/block-mesh-dict'
import { exodus } from './formats/exodus'
import { gmsh } from './formats/gmsh'
import { kratos } from './formats/kratos'
import { libMesh } from './formats/libmesh'
import { link } from './formats/link'
import { lsDyna } from './formats/ls-dyna'
import { medit } from './formats/medit'
import { mfem } from './formats/mfem'
import { nastran } from './formats/nastran'
import { ncdump } from './formats/ncdump'
import { obj } from './formats/obj'
import { openFoam } from './formats/openfoam'
import { ovm } from './formats/ovm'
import { picture } from './formats/picture'
import { refused } from './formats/refused'
import { tecplot } from './formats/tecplot'
import { text } from './formats/text'
import { ucd } from './formats/ucd'
import { unv } from './formats/unv'
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
  exodus,
  libMesh,
  ucd,
  unv,
  ovm,
  kratos,
  tecplot,
  blockMeshDict,
  openFoam,
  ncdump,
  obj,
  picture,
  link,
  refused,
  text, // last: what no other claims
]
