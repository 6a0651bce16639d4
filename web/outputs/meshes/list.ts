/** The formats that checked meshes are written in: the first where nothing else is said. */
import { abaqus } from './abaqus'
import { gmsh } from './gmsh'
import type { MeshForm } from './mesh-form'
import { vtk } from './vtk'
import { vtu } from './vtu'

export const MESH_FORMS: readonly [MeshForm, ...MeshForm[]] = [vtu, vtk, gmsh, abaqus]
