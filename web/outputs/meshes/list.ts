/** The formats that checked meshes are written in: the first where nothing else is said. */
import { abaqus } from './abaqus'
import { FORM_WORDS } from './form-words'
import { gmsh } from './gmsh'
import type { MeshForm, MeshWriter } from './mesh-form'
import { vtk } from './vtk'
import { vtu } from './vtu'

const form = (id: keyof typeof FORM_WORDS, writer: MeshWriter): MeshForm => ({ id, ...FORM_WORDS[id], ...writer })

export const MESH_FORMS: readonly [MeshForm, ...MeshForm[]] = [
  form('vtu', vtu),
  form('vtk', vtk),
  form('msh', gmsh),
  form('inp', abaqus),
]
