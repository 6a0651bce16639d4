/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { abaqus } from './formats/abaqus'
import { ansysCdb } from './formats/ansys-cdb'
import { lsDyna } from './formats/ls-dyna'
import { nastran } from './formats/nastran'
import type { MeshFormat } from './source'

export const formats: readonly MeshFormat[] = [abaqus, nastran, ansysCdb, lsDyna]
