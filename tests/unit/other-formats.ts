/** One mesh of shaken hexahedra as texts and bytes of many formats, with ids in no order where the format has ids. */
import { randomSource } from './core-fixtures'

const PER_SIDE = 4
const COUNT = PER_SIDE ** 3

const random = randomSource(2201)
const along = Array.from({ length: PER_SIDE + 1 }, (_, i) => i)
export const points = along.flatMap(z =>
  along.flatMap(y => along.map(x => [x, y, z].map(value => (value + 0.3 * (2 * random() - 1)) / 7))),
)
const [row, layer] = [PER_SIDE + 1, (PER_SIDE + 1) ** 2]
const ofCell = along.slice(1)
export const cells = ofCell.flatMap(k =>
  ofCell.flatMap(j =>
    ofCell.map(i => {
      const first = i - 1 + row * (j - 1) + layer * (k - 1)
      return [0, 1, 1 + row, row, layer, layer + 1, layer + 1 + row, layer + row].map(step => first + step)
    }),
  ),
)

function shuffled(count: number): number[] {
  const list = Array.from({ length: count }, (_, i) => i + 1)
  for (let i = count - 1; i > 0; --i) {
    const j = Math.floor(random() * (i + 1))
    const [a, b] = [list[i] as number, list[j] as number]
    list[i] = b
    list[j] = a
  }
  return list
}

const nodeIds = shuffled(points.length)
export const cellIds = shuffled(COUNT)
const byIds = cells.map(cell => cell.map(point => nodeIds[point] as number))

const lines = <T>(list: readonly T[], line: (one: T, i: number) => string) => list.map(line).join('')
const nodeLines = (before: string) => lines(points, (point, i) => `${before}${nodeIds[i]} ${point.join(' ')}\n`)
const cellLines = (before: string, order = [0, 1, 2, 3, 4, 5, 6, 7]) =>
  lines(byIds, (cell, i) => `${before}${cellIds[i]} ${order.map(v => cell[v]).join(' ')}\n`)
const columns = (list: readonly (number | string)[], width: number) =>
  list.map(value => String(value).padStart(width)).join('')

const FACES = [
  [0, 4, 7, 3],
  [1, 2, 6, 5],
  [0, 1, 5, 4],
  [3, 7, 6, 2],
  [0, 3, 2, 1],
  [4, 5, 6, 7],
] as const

interface Face {
  readonly points: readonly number[]
  readonly owner: number
  readonly neighbour: number | null
}

/** All faces, seen from outside of their owner; those with a neighbour first. */
function facesOfCells(): Face[] {
  const known = new Map<string, { points: number[]; owner: number; neighbour: number | null }>()
  for (const [c, cell] of cells.entries())
    for (const face of FACES) {
      const own = face.map(v => cell[v] as number)
      const key = own.toSorted((a, b) => a - b).join()
      const other = known.get(key)
      if (other) other.neighbour = c
      else known.set(key, { points: own, owner: c, neighbour: null })
    }
  return [...known.values()].sort((a, b) => Number(a.neighbour === null) - Number(b.neighbour === null))
}

const faces = facesOfCells()
const inside = faces.filter(({ neighbour }) => neighbour !== null)

export const TEXTS: Readonly<Record<string, string>> = {
  'a.su2': `% a comment\nNDIME= 3\nNELEM= ${COUNT}\n${lines(cells, (cell, i) => `12 ${cell.join(' ')} ${i}\n`)}NPOIN= ${points.length}\n${lines(points, (point, i) => `${point.join('\t')} ${i}\n`)}NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n9 0 1 2 3\n`,
  'a.f3grid': `* FLAC3D grid\n${nodeLines('G ')}${cellLines('Z B8 ', [0, 1, 3, 4, 2, 7, 5, 6])}ZGROUP "hard rock" SLOT 1\n${cellIds.slice(0, 3).join(' ')}\nFGROUP wall\n1 2\n`,
  'a.dato': `!PERMAS\n$ENTER COMPONENT NAME=A\n$STRUCTURE\n$ELEMENT TYPE=HEXE8 ESET=body\n${cellLines('')}!\n$COOR\n${nodeLines('')}$END STRUCTURE\n$EXIT COMPONENT\n$FIN\n`,
  'a.rad': `#RADIOSS STARTER\n/BEGIN\na\n      2022         0\n/BRICK/3\n${lines(byIds, (cell, i) => `${columns([cellIds[i] as number, ...cell], 10)}\n`)}/PART/3\nengine block\n         1         1\n/NODE\n${lines(
    points,
    (point, i) =>
      `${columns([nodeIds[i] as number], 10)}${columns(
        point.map(value => value.toPrecision(13)),
        20,
      )}\n`,
  )}/END\n`,
  'a.mail': ` TITRE\nmade up, FINSF not\n FINSF\n %\n HEXA8\n${lines(
    byIds,
    (cell, i) =>
      ` M${cellIds[i]} ${cell
        .slice(0, 4)
        .map(node => `N${node}`)
        .join(' ')}\n   ${cell
        .slice(4)
        .map(node => `N${node}`)
        .join(',')}\n`,
  )} FINSF\n % a comment\n COOR_3D NOM=INDEFINI NBOBJ=125 NBLIGE=2\n  NUMERO=1\n${nodeLines(' N')} FINSF\n GROUP_MA NOM = LEFT\n M1 M2\n FINSF\n FIN\n`,
  'a.feb': `<?xml version="1.0" encoding="ISO-8859-1"?>\n<febio_spec version="2.5">\n\t<Geometry>\n\t\t<Elements type="hex8" mat="1" name="Part1">\n${lines(byIds, (cell, i) => `\t\t\t<elem id="${cellIds[i]}">${cell.join(', ')}</elem>\n`)}\t\t</Elements>\n\t\t<Nodes>\n${lines(points, (point, i) => `\t\t\t<node id="${nodeIds[i]}">${point.join(', ')}</node>\n`)}\t\t</Nodes>\n\t</Geometry>\n</febio_spec>\n`,
  'a.ugrid': `${points.length} 0 1 0 0 0 ${COUNT}\n${lines(points, point => `${point.join(' ')}\n`)}1 2 3 4\n7\n${lines(cells, cell => `${cell.map(point => point + 1).join(' ')}\n`)}`,
  'fluent.msh': `(0 "made (up)")\n(2 3)\n(10 (0 1 ${points.length.toString(16)} 0 3))\n(10 (1 1 ${points.length.toString(16)} 1 3)(\n${lines(points, point => `${point.join(' ')}\n`)}))\n(12 (2 1 ${COUNT.toString(16)} 1 4))\n(13 (3 1 ${inside.length.toString(16)} 2 4)(\n${lines(inside, face => fluentFace(face))}))\n(13 (4 ${(inside.length + 1).toString(16)} ${faces.length.toString(16)} 3 0)(\n${lines(faces.slice(inside.length), face => `4 ${fluentFace(face)}`)}))\n(45 (2 fluid air)())\n`,
}

/** Seen from inside of c0, which is the neighbour; without one the owner, and its face turned round. */
function fluentFace({ points: own, owner, neighbour }: Face): string {
  const nodes = neighbour === null ? own.toReversed() : own
  const sides = neighbour === null ? [owner + 1, 0] : [neighbour + 1, owner + 1]
  return `${[...nodes.map(point => point + 1), ...sides].map(value => value.toString(16)).join(' ')}\n`
}

export const ELMER: Readonly<Record<string, string>> = {
  'mesh.elements': lines(byIds, (cell, i) => `${cellIds[i]} 1 808 ${cell.join(' ')}\n`),
  'mesh.nodes': lines(points, (point, i) => `${nodeIds[i]} -1 ${point.join(' ')}\n`),
  'mesh.header': `${points.length} ${COUNT} 0\n1\n808 ${COUNT}\n`,
  'mesh.names': '! ----- names for bodies -----\n$ steel = 1\n! ----- names for boundaries -----\n$ wall = 1\n',
}

const foamHeader = (className: string, name: string, format: string) =>
  `/* a banner */\nFoamFile\n{\n    version     2.0;\n    format      ${format};\n    arch        "LSB;label=32;scalar=64";\n    class       ${className};\n    location    "constant/polyMesh";\n    object      ${name};\n}\n// * * //\n\n`
const foamText = (className: string, name: string, list: readonly string[]) =>
  `${foamHeader(className, name, 'ascii')}${list.length}\n(\n${list.join('\n')}\n)\n\n// ** //\n`
const labels = (list: readonly number[]) => new Uint8Array(Int32Array.from(list).buffer)
const joined = (...parts: readonly (string | Uint8Array)[]) =>
  new Uint8Array(Buffer.concat(parts.map(part => Buffer.from(part))))

const owners = faces.map(({ owner }) => owner)
const neighbours = inside.map(({ neighbour }) => neighbour as number)

export const FOAM: Readonly<Record<string, string>> = {
  boundary: foamText('polyBoundaryMesh', 'boundary', ['wall { type wall; nFaces 96; startFace 144; }']),
  cellZones: foamText('regIOobject', 'cellZones', ['rotor { type cellZone; cellLabels List<label> 3(0 5 2); }']),
  faces: foamText(
    'faceList',
    'faces',
    faces.map(({ points: own }) => `4(${own.join(' ')})`),
  ),
  neighbour: foamText('labelList', 'neighbour', neighbours.map(String)),
  owner: foamText('labelList', 'owner', owners.map(String)),
  points: foamText(
    'vectorField',
    'points',
    points.map(point => `(${point.join(' ')})`),
  ),
}

const foamLabels = (list: readonly number[]) => [`${list.length}\n(`, labels(list), ')'] as const

export const FOAM_BINARY: Readonly<Record<string, Uint8Array>> = {
  cellZones: joined(
    foamHeader('regIOobject', 'cellZones', 'binary'),
    '1\n(\nrotor\n{\ntype cellZone;\ncellLabels List<label> \n',
    ...foamLabels([0, 2, 5]),
    ';\n}\n)\n',
  ),
  faces: joined(
    foamHeader('faceCompactList', 'faces', 'binary'),
    ...foamLabels([0, ...faces.map((_, f) => 4 * f + 4)]),
    '\n',
    ...foamLabels(faces.flatMap(({ points: own }) => own)),
  ),
  neighbour: joined(foamHeader('labelList', 'neighbour', 'binary'), ...foamLabels(neighbours)),
  owner: joined(foamHeader('labelList', 'owner', 'binary'), ...foamLabels(owners)),
  points: joined(
    foamHeader('vectorField', 'points', 'binary'),
    `${points.length}\n(`,
    new Uint8Array(Float64Array.from(points.flat()).buffer),
    ')\n',
  ),
}

/** UGRID as the kind says: little-endian, records, bytes of a coordinate and of an integer. */
export function ugridOfBytes(isLittle: boolean, hasRecords: boolean, floatBytes: 4 | 8, intBytes: 4 | 8): Uint8Array {
  const parts: Uint8Array[] = []
  const put = (bytes: number, set: (view: DataView) => void) => {
    const view = new DataView(new ArrayBuffer(bytes))
    set(view)
    return new Uint8Array(view.buffer)
  }
  const int = (value: number, bytes: 4 | 8 = intBytes) =>
    put(bytes, view => (bytes === 8 ? view.setBigInt64(0, BigInt(value), isLittle) : view.setInt32(0, value, isLittle)))
  const float = (value: number) =>
    put(floatBytes, view =>
      floatBytes === 8 ? view.setFloat64(0, value, isLittle) : view.setFloat32(0, value, isLittle),
    )
  const record = (own: readonly Uint8Array[]) => {
    const length = own.reduce((sum, part) => sum + part.length, 0)
    parts.push(...(hasRecords ? [int(length, 4), ...own, int(length, 4)] : own))
  }
  record([points.length, 0, 1, 0, 0, 0, COUNT].map(value => int(value)))
  record([
    ...points.flat().map(float),
    ...[1, 2, 3, 4, 7].map(value => int(value)),
    ...cells.flat().map(point => int(point + 1)),
  ])
  return joined(...parts)
}

/** Exodus II in netCDF classic (1), with 64-bit offsets (2) or data (5). */
export function exodusOf(version: 1 | 2 | 5): Uint8Array {
  const bytes: number[] = []
  const big = (value: number, size: 4 | 8) => {
    const view = new DataView(new ArrayBuffer(8))
    view.setBigInt64(0, BigInt(value))
    bytes.push(...new Uint8Array(view.buffer).subarray(8 - size))
  }
  const count = (value: number) => big(value, version === 5 ? 8 : 4)
  const name = (text: string) => {
    count(text.length)
    bytes.push(...new TextEncoder().encode(text), ...Array.from({ length: (4 - (text.length % 4)) % 4 }, () => 0))
  }
  const dimensions: readonly (readonly [string, number])[] = [
    ['time_step', 0],
    ['num_nodes', points.length],
    ['num_elem', COUNT],
    ['num_el_in_blk1', COUNT],
    ['num_nod_per_el1', 8],
    ['num_el_blk', 1],
    ['len_name', 8],
  ]
  const doubles = (list: readonly number[]) =>
    new Uint8Array(Float64Array.from(list).buffer).map((_, i, all) => all[8 * (i >> 3) + 7 - (i % 8)] as number)
  const ints = (list: readonly number[]) => labels(list).map((_, i, all) => all[4 * (i >> 2) + 3 - (i % 4)] as number)
  const variables: readonly (readonly [string, number, readonly number[], Uint8Array])[] = [
    ...['x', 'y', 'z'].map(
      (axis, a) => [`coord${axis}`, 6, [1], doubles(points.map(point => point[a] as number))] as const,
    ),
    ['eb_names', 2, [5, 6], new TextEncoder().encode('engine\0\0')],
    ['eb_prop1', 4, [5], ints([10])],
    ['elem_num_map', 4, [2], ints(cellIds)],
    ['connect1', 4, [3, 4], ints(cells.flat().map(point => point + 1))],
    ['time_whole', 6, [0], doubles([0, 0.5])],
    ['vals', 6, [0, 1], new Uint8Array(16 * points.length)],
  ]
  const header = (begins: readonly number[]) => {
    bytes.length = 0
    bytes.push(67, 68, 70, version)
    count(2)
    big(10, 4)
    count(dimensions.length)
    for (const [own, length] of dimensions) {
      name(own)
      count(length)
    }
    big(0, 4)
    count(0)
    big(11, 4)
    count(variables.length)
    for (const [i, [own, type, of, data]] of variables.entries()) {
      name(own)
      count(of.length)
      for (const dimension of of) count(dimension)
      if (own === 'connect1') {
        big(12, 4)
        count(1)
        name('elem_type')
        big(2, 4)
        count(4)
        bytes.push(...new TextEncoder().encode('HEX8'))
      } else {
        big(0, 4)
        count(0)
      }
      big(type, 4)
      count(data.length)
      big(begins[i] ?? 0, version === 1 ? 4 : 8)
    }
    return bytes.length
  }
  let next = header([])
  const [, time, values] = [0, variables[7], variables[8]] as unknown as [
    number,
    (typeof variables)[0],
    (typeof variables)[0],
  ]
  const begins = variables.slice(0, 7).map(([, , , data]) => {
    const begin = next
    next += data.length
    return begin
  })
  begins.push(next, next + 8)
  header(begins)
  // Records lie together: one of each variable after another.
  const perRecord = 8 * points.length
  const records = [0, 1].flatMap(i => [
    time[3].subarray(8 * i, 8 * i + 8),
    values[3].subarray(perRecord * i, perRecord * (i + 1)),
  ])
  return joined(Uint8Array.from(bytes), ...variables.slice(0, 7).map(([, , , data]) => data), ...records)
}
