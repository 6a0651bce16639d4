/** What is to be said of files of the mesh that was made: why less, or something else, is in them than was written. */
import type { Answer, Standing } from './made-mesh'
import { type MadeRecord, PEERS, type Peer, recordOf } from './peers'

/** What is found in a file, as far as that shows what is said of it. */
interface Found {
  readonly counts?: Readonly<Record<string, number>>
  readonly standings?: Partial<Readonly<Record<Standing, number>>>
}

export interface FileFact extends Found {
  readonly path: string
  /** A sentence. */
  readonly says: string
  /** What peers have found. */
  readonly peers?: Partial<Readonly<Record<Peer, Found | 'refused'>>>
}

export const FILE_FACTS: readonly FileFact[] = [
  {
    path: 'meshio.h5m',
    says: 'meshio writes lines, triangles and tetrahedra alone for MOAB: the two tetrahedra are there, and no hexahedra.',
    counts: { hexahedron: 0, tetrahedron: 2 },
    standings: {},
    peers: { meshio: { counts: { tetrahedron: 2 }, standings: {} } },
  },
  {
    path: 'meshio.f3grid',
    says: 'FLAC3D’s zones are right-handed, and meshio turns those round that are not: the mirrored cell is a valid one in the file.',
    standings: { exact: 14, reordered: 1 },
    peers: { meshio: { standings: { exact: 14, reordered: 1 } } },
  },
  {
    path: 'gmsh.rad',
    says: 'Gmsh writes six digits for Radioss, so that the thinnest cell is 0.001 thick in place of 2^-10, and no pyramid.',
    counts: { pyramid: 0 },
    standings: { exact: 14, rounded: 1 },
  },
  {
    path: 'gmsh.unv',
    says: 'Gmsh writes no pyramid for UNV.',
    counts: { pyramid: 0 },
    standings: { exact: 15 },
    peers: { Gmsh: { counts: { pyramid: 0 } } },
  },
  {
    path: 'gmsh.key',
    says: 'Gmsh writes no pyramid for LS-DYNA, and rounds coordinates.',
    counts: { pyramid: 0 },
    standings: { exact: 14, rounded: 1 },
  },
  {
    path: 'meshio.med',
    says: 'meshio writes the nodes in VTK’s order, where MED has another, and reads them so; Gmsh reads them in MED’s.',
    standings: { exact: 15 },
    peers: { meshio: { standings: { exact: 15 } }, Gmsh: { standings: { reordered: 15 } } },
  },
  {
    path: 'vtk-raw-none.vtu',
    says: 'One cell is a voxel, here as in all files that VTK has written; meshio leaves it out.',
    counts: { hexahedron: 16 },
    peers: { VTK: { counts: { voxel: 1 } }, meshio: { counts: { voxel: 0, hexahedron: 15 } } },
  },
  {
    path: 'vtk-legacy51-bin.vtk',
    says: 'Gmsh refuses VTK’s legacy files of version 5.1 in bytes, those of VTK itself as those that Hexlens writes.',
    counts: { hexahedron: 16 },
    peers: { VTK: { standings: { exact: 16 } }, Gmsh: 'refused' },
  },
  {
    path: 'hand.cdb',
    says: 'Ansys has the wedge, the pyramid and the tetrahedra as hexahedra with repeated nodes: the last four.',
    counts: { hexahedron: 19 },
    standings: { exact: 15, moved: 2, other: 2 },
  },
  {
    path: 'hand-continued.inp',
    says: 'The part has two instances, one of them elsewhere.',
    standings: { exact: 15, moved: 15 },
  },
  {
    path: 'foam/constant/polyMesh/faces',
    says: 'Faces give a cell eight nodes, and leave open at which of them it begins.',
    standings: { exact: 3, reordered: 1 },
    peers: { VTK: { standings: { reordered: 4 } } },
  },
]

/** What of the fact is not so; empty if all is. */
export function contradictions(fact: FileFact, answer: Answer, peers: Readonly<Record<Peer, MadeRecord>>): string[] {
  return [
    ...differences('Hexlens', fact, recordOf(answer)),
    ...PEERS.flatMap(peer => {
      const wanted = fact.peers?.[peer]
      const found = peers[peer]
      if (wanted === 'refused') return found !== null && 'refused' in found ? [] : [`${peer} does not refuse it.`]
      return wanted ? differences(peer, wanted, found) : []
    }),
  ]
}

function differences(name: string, { counts = {}, standings }: Found, found: MadeRecord): string[] {
  if (found === null || 'refused' in found) return [`${name} does not read it.`]
  const types = Object.keys(counts).filter(type => (found.counts[type] ?? 0) !== counts[type])
  const areSame = standings === undefined || sorted(standings) === sorted(found.standings)
  return [
    ...types.map(type => `${name} finds ${found.counts[type]} of ${type}, not ${counts[type]}.`),
    ...(areSame ? [] : [`The hexahedra of ${name} are ${sorted(found.standings)}, not ${sorted(standings ?? {})}.`]),
  ]
}

function sorted(standings: Partial<Readonly<Record<Standing, number>>>): string {
  return JSON.stringify(Object.entries(standings).sort())
}
