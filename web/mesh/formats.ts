/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { blockMeshDict } from './formats/block-mesh-dict'
import { kratos } from './formats/kratos'
import { libMesh } from './formats/libmesh'
import { link } from './formats/link'
import { ncdump } from './formats/ncdump'
import { obj } from './formats/obj'
import { ovm } from './formats/ovm'
import { refused } from './formats/refused'
import { tecplot } from './formats/tecplot'
import { text } from './formats/text'
import { ucd } from './formats/ucd'
import { unv } from './formats/unv'
import type { MeshFormat } from './source'

export const formats: readonly MeshFormat[] = [
  libMesh,
  ucd,
  unv,
  ovm,
  kratos,
  tecplot,
  blockMeshDict,
  ncdump,
  obj,
  link,
  refused,
  text, // last: what no other claims
]
