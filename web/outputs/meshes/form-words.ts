/** What people are told of the formats that checked meshes are written in, by how their files end, without the point. */

export interface FormWords {
  readonly name: string
  /** What is in the file of a whole mesh. */
  readonly what: string
  /** The same of a file that has the invalid cells alone. */
  readonly whatOfPart: string
  readonly mediaType: string
}

export const FORM_WORDS = {
  vtu: {
    name: 'VTU',
    what: 'the mesh with valid, boundary_min, relative_min and volume, for ParaView',
    whatOfPart: 'these cells alone, with their indices and ids',
    mediaType: 'model/vnd.vtu',
  },
  vtk: {
    name: 'VTK',
    what: 'the same in the legacy format of version 5.1',
    whatOfPart: 'the same in the legacy format of version 5.1',
    mediaType: 'application/octet-stream',
  },
  msh: {
    name: 'Gmsh',
    what: 'the same in the format 4.1, each array as a view',
    whatOfPart: 'the same in the format 4.1, each array as a view',
    mediaType: 'model/mesh',
  },
  inp: {
    name: 'Abaqus',
    what: 'elements C3D8, with an ELSET of those that are invalid',
    whatOfPart: 'these cells as elements C3D8',
    mediaType: 'text/plain',
  },
} satisfies Readonly<Record<string, FormWords>>
