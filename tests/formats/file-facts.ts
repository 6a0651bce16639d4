/** What is to be said of files of the mesh that was made: why less, or something else, is in them than was written. */
import { type Answer, type Standing, standingsOf } from './made-mesh'
import type { MadeRecord, Peer } from './peers'

export interface FileFact {
  readonly path: string
  /** A sentence. */
  readonly says: string
  /** What is read of it, as far as that shows what is said. */
  readonly counts?: Readonly<Record<string, number>>
  readonly standings?: Partial<Readonly<Record<Standing, number>>>
  /** Peers that find the same cells. */
  readonly alsoBy?: readonly Peer[]
}

export const FILE_FACTS: readonly FileFact[] = [
  {
    path: 'meshio.h5m',
    says: 'meshio writes lines, triangles and tetrahedra alone for MOAB: the two tetrahedra are there, and no hexahedra.',
    counts: { hexahedron: 0, tetrahedron: 2 },
    standings: {},
    alsoBy: ['meshio'],
  },
  {
    path: 'meshio.f3grid',
    says: 'FLAC3D’s zones are right-handed, and meshio turns those round that are not: the mirrored cell is a valid one in the file.',
    standings: { exact: 14, reordered: 1 },
    alsoBy: ['meshio'],
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
    alsoBy: ['Gmsh'],
  },
  { path: 'gmsh.key', says: 'Gmsh writes no pyramid for LS-DYNA.', counts: { pyramid: 0 } },
  {
    path: 'meshio.med',
    says: 'meshio writes the nodes in VTK’s order, where MED has another: read by MED’s rules, as Gmsh reads it, every cell is turned inside out.',
    standings: { exact: 15 },
    alsoBy: ['meshio'],
  },
  {
    path: 'hand.cdb',
    says: 'Ansys has the wedge, the pyramid and the tetrahedra as hexahedra with repeated nodes.',
    standings: { exact: 15, other: 4 },
  },
  {
    path: 'hand-continued.inp',
    says: 'The part has two instances, one of them elsewhere.',
    standings: { exact: 15, moved: 15 },
  },
  {
    path: 'foam/constant/polyMesh/faces',
    says: 'Faces give a cell eight nodes, and leave open at which of them it begins.',
    standings: { reordered: 4 },
    alsoBy: ['VTK'],
  },
]

/** What of the fact is not so; empty if all is. */
export function contradictions(fact: FileFact, answer: Answer, peers: Readonly<Record<Peer, MadeRecord>>): string[] {
  if (answer === null || 'refused' in answer) return ['It is not read.']
  const wanted = JSON.stringify(fact.standings)
  const standings = JSON.stringify(standingsOf(answer.hexahedra))
  return [
    ...(fact.standings === undefined || wanted === standings ? [] : [`The hexahedra are ${standings}, not ${wanted}.`]),
    ...Object.entries(fact.counts ?? {}).flatMap(([type, count]) =>
      (answer.counts[type] ?? 0) === count ? [] : [`There are ${answer.counts[type]} of ${type}.`],
    ),
    ...(fact.alsoBy ?? []).flatMap(peer => {
      const own = peers[peer]
      const isSame = own !== null && 'standings' in own && JSON.stringify(own.standings) === standings
      return isSame ? [] : [`${peer} finds something else.`]
    }),
  ]
}
