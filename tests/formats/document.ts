/** docs/formats.md, printed from what the tests hold to be true. */
import { readFileSync } from 'node:fs'
import { refusedMeshes } from '../../web/mesh/formats/refused-meshes'
import { MESH_FORMS } from '../../web/outputs/meshes/list'
import type { Fact } from './fact'
import { FACTS } from './facts'
import { FILE_FACTS } from './file-facts'
import { answerOf, madeFiles } from './made-mesh'
import { type MadeRecord, PEERS, type PeerRecord, recordOf, type WrittenRecord } from './peers'

export const peers: PeerRecord = JSON.parse(readFileSync(new URL('peers.json', import.meta.url), 'utf8'))

const COLUMNS = 100

export function formatsDocument(): string {
  return [
    '# Formats',
    '<!-- Written by npm run formats from tests/formats: every clause of the tables is a test there. -->',
    wrapped(
      'What is read of each format, and what is not. A file is known by its bytes, not by its name, and may be gzipped. In all formats hexahedra of 20 or 27 nodes and Lagrange cells are counted apart, as they are not trilinear; other cells are counted by type. A file that is damaged is refused with its place, never read in part; a text that is cut or leaves something out is read as far as its cells are whole, and says so.',
    ),
    wrapped(
      'Files that belong together, those of OpenFOAM and of Elmer, and those that others name, are found beside the one that is read, or dropped with it. The folder of a whole OpenFOAM case may be dropped: its mesh is read, and one note names the other files.',
    ),
    table(
      ['format', 'read', 'left out or refused'],
      FACTS.map(({ format, read, notRead }) => [format, clauses(read), clauses(notRead)]),
    ),
    '## In HDF5',
    wrapped(
      'CGNS, MED, VTKHDF, MOAB, HMF, Exodus II in netCDF-4 and the numbers of XDMF are read with h5wasm 0.10, which is HDF5 2.0 in wasm: 1 MB, loaded with the first such file. Of a large file only the parts that are wanted are read, 4 MB or a chunk at a time. Numbers may be packed by gzip, with shuffle or checksums, and in either order of bytes. SZIP is read; other filters, such as LZF and Blosc, are refused by name. A dataset that claims more bytes than the file can hold is refused before anything is read of it.',
    ),
    '## Refused by name',
    wrapped(
      `Of other files a sentence says what they are and which program converts them: ${refusedMeshes.map(({ what }) => what).join('; ')}.`,
    ),
    '## The same mesh, read by others',
    wrapped(
      `Fifteen hexahedra, among them mirrored and collapsed ones, and some cells of other types were written as files by meshio, VTK, Gmsh and by hand, as the names say. The table has what is found in each file: by Hexlens, and by VTK ${peers.versions.VTK}, meshio ${peers.versions.meshio} and Gmsh ${peers.versions.Gmsh} when \`npm run peers\` asked them last.`,
    ),
    [
      '- *all*: every cell that was written, with the same coordinates, bit for bit;',
      '- *rounded*: hexahedra with coordinates that differ in their last digits;',
      '- *reordered*: hexahedra with the same eight nodes in another order;',
      '- *moved*: hexahedra that are the same elsewhere;',
      '- *refused*: the program ends with an error, or finds nothing;',
      '- a dash: the program has no reader for such a file.',
    ].join('\n'),
    table(
      ['file', 'Hexlens', ...PEERS],
      madeFiles.map(({ path, counts }) => [
        `\`${path}\``,
        found(counts, recordOf(answerOf(path))),
        ...PEERS.map(peer => found(counts, peers.made[path]?.[peer] ?? null)),
      ]),
    ),
    FILE_FACTS.map(({ path, says }) => wrapped(`- \`${path}\`: ${says}`, '  ')).join('\n'),
    '## What is written',
    wrapped(
      'The page Mesh and `hexlens check --annotate` write checked meshes in these formats. `hexlens check` reads each back bit for bit. VTK, meshio and Gmsh read back what the table says: of the hexahedra all coordinates, and the arrays `valid`, `boundary_min`, `relative_min` and `volume`.',
    ),
    table(
      ['format', 'ending', ...PEERS],
      MESH_FORMS.map(({ id, name }) => [
        name,
        `\`.${id}\``,
        ...PEERS.map(peer => readBack(peers.written[`written.${id}`]?.[peer] ?? null)),
      ]),
    ),
  ]
    .join('\n\n')
    .concat('\n')
}

function clauses(facts: readonly Fact[]): string {
  return facts.length === 0 ? '-' : facts.map(({ says }) => says).join('; ')
}

/** Types of hexahedra; the first two are trilinear. */
const TRILINEAR = ['hexahedron', 'voxel']
const CURVED = /^hexahedron of|^Lagrange/

function byKind(counts: Readonly<Record<string, number>>): ReadonlyMap<string, number> {
  const kinds = new Map<string, number>()
  for (const [type, count] of Object.entries(counts)) {
    const kind = TRILINEAR.includes(type) ? 'hexahedron' : CURVED.test(type) ? 'hexahedron of more nodes' : type
    kinds.set(kind, (kinds.get(kind) ?? 0) + count)
  }
  return kinds
}

/** In few words, against the cells that were written. */
function found(counts: Readonly<Record<string, number>>, record: MadeRecord): string {
  if (record === null) return '-'
  if ('refused' in record) return 'refused'
  const written = byKind(counts)
  const own = byKind(record.counts)
  const kinds = [...new Set([...written.keys(), ...own.keys()])]
  const differences = kinds.flatMap(kind => {
    const [count = 0, wanted = 0] = [own.get(kind), written.get(kind)]
    return count === wanted
      ? []
      : [count === 0 ? `no ${plural(kind, wanted)}` : `${count} of ${wanted} ${plural(kind, wanted)}`]
  })
  const { exact: _, ...standings } = record.standings
  const words = [
    ...(differences.length === 0 ? ['all'] : differences),
    ...Object.entries(standings).map(([standing, count]) => `${count} ${standing}`),
  ]
  return words.join(', ')
}

function plural(kind: string, count: number): string {
  return count === 1
    ? kind
    : kind
        .replace('hexahedron', 'hexahedra')
        .replace('tetrahedron', 'tetrahedra')
        .replace(/l$|d$|e$/, '$&s')
}

function readBack(record: WrittenRecord): string {
  if (record === null) return '-'
  if ('refused' in record) return 'refused'
  const cells = record.areHexahedraSame ? 'the same' : 'others'
  return record.arrays.length === 4 ? `${cells}, with all arrays` : cells
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const line = (cells: readonly string[]) => `| ${cells.map(cell => cell.replaceAll('|', '\\|')).join(' | ')} |`
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n')
}

/** In lines of 100 characters. */
function wrapped(text: string, indent = ''): string {
  const lines: string[] = []
  let line = ''
  for (const word of text.split(' ')) {
    if (line !== '' && line.length + 1 + word.length > COLUMNS) {
      lines.push(line)
      line = `${indent}${word}`
    } else line = line === '' ? word : `${line} ${word}`
  }
  return [...lines, line].join('\n')
}
