/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { abaqus } from './formats/abaqus'
import { ansysCdb } from './formats/ansys-cdb'
import { aster } from './formats/aster'
import { blockMeshDict } from './formats/block-mesh-dict'
import { elmer } from './formats/elmer'
import { exodus } from './formats/exodus'
import { febio } from './formats/febio'
import { flac3d } from './formats/flac3d'
import { fluent } from './formats/fluent'
import { gmsh } from './formats/gmsh'
import { hdf5, inHdf5 } from './formats/hdf5'
import { kratos } from './formats/kratos'
import { libMesh } from './formats/libmesh'
import { link } from './formats/link'
import { lsDyna } from './formats/ls-dyna'
import { medit } from './formats/medit'
import { mfem } from './formats/mfem'
import { nastran } from './formats/nastran'
import { ncdump } from './formats/ncdump'
import { nek } from './formats/nek'
import { obj } from './formats/obj'
import { openFoam } from './formats/openfoam'
import { ovm } from './formats/ovm'
import { permas } from './formats/permas'
import { picture } from './formats/picture'
import { radioss } from './formats/radioss'
import { refused } from './formats/refused'
import { su2 } from './formats/su2'
import { tecplot } from './formats/tecplot'
import { text } from './formats/text'
import { ucd } from './formats/ucd'
import { ugrid } from './formats/ugrid'
import { unv } from './formats/unv'
import { vtkLegacy } from './formats/vtk-legacy'
import { vtu } from './formats/vtu'
import { xdmf } from './formats/xdmf'
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
  su2,
  febio,
  aster,
  elmer,
  flac3d,
  permas,
  radioss,
  ugrid,
  xdmf,
  fluent,
  libMesh,
  ucd,
  unv,
  ovm,
  kratos,
  tecplot,
  blockMeshDict,
  openFoam,
  ncdump,
  nek,
  obj,
  hdf5,
  ...inHdf5,
  picture,
  link,
  refused,
  text, // last: what no other claims
]
