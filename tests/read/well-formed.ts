/** The law for every mesh that is read, and for every sentence that is said in its place. */
import type { CoordinatePlaces, Mesh } from '../../web/mesh/mesh'

/** The first thing that is wrong with a mesh read from `bytes`, null if there is none. */
export function faultOfMesh(mesh: Mesh, bytes: Uint8Array): string | null {
  const { points, cells, ids, blocks, notTrilinear, other, notes, steps, coordinatePlaces } = mesh
  const count = cells.length / 8
  const cornersCount = notTrilinear.corners.length / 8
  if (!(points instanceof Float64Array) || points.length % 3 !== 0) return `${points.length} coordinates`
  for (const [list, what] of [
    [cells, 'cells'],
    [notTrilinear.corners, 'corners'],
  ] as const) {
    if (!(list instanceof Uint32Array) || list.length % 8 !== 0) return `${list.length} numbers of ${what}`
    for (let i = 0; i < list.length; ++i)
      if (3 * (list[i] as number) >= points.length) return `${what} name point ${list[i]} of ${points.length / 3}`
  }
  const { straight } = notTrilinear
  if (straight !== null && !(straight >= 0 && straight <= cornersCount)) return `${straight} straight cells`
  if (ids !== null && ids.length !== count) return `${ids.length} ids for ${count} cells`
  if (ids !== null && !(ids instanceof Float64Array) && ids.some(id => typeof id !== 'string'))
    return 'ids of two kinds'
  for (const block of blocks) {
    let before = -1
    for (const cell of block.cells) {
      if (cell <= before || cell >= count) return `cell ${cell} after ${before} in block ${block.name}, of ${count}`
      before = cell
    }
  }
  for (const [type, number] of other)
    if (!/^[a-z ]+$/.test(type) || !Number.isSafeInteger(number) || number <= 0) return `${number} times ${type}`
  if (mesh.format === '' || steps.some(step => typeof step !== 'string')) return 'no format, or steps that are no text'
  for (const note of notes) {
    const fault = faultOfSentence(note)
    if (fault !== null) return `note “${note}”: ${fault}`
  }
  return coordinatePlaces === null ? null : faultOfPlaces(coordinatePlaces, points, bytes)
}

const LONGEST_SENTENCE = 700

/** The first thing that is wrong with a sentence for people, null if there is none. */
export function faultOfSentence(sentence: string): string | null {
  if (/[\p{Cc}\p{Cf}\u2028\u2029]/u.test(sentence)) return 'a control character'
  if (sentence.length > LONGEST_SENTENCE) return `${sentence.length} characters`
  if (!/^\S.*[.?)]$/.test(sentence)) return 'no sentence'
  // The words of a file stand in quotes, its tags as they are.
  const own = sentence.replace(/“[^”]*”|<[^>]*>/g, '')
  if (/undefined|NaN|Infinity|\[object|function|null\b/.test(own)) return 'a value that is none'
  return /needs more memory/.test(own) ? 'memory that nobody needs' : null
}

/** As the formats with places write numbers, read without any of the readers' code. */
function doubleOf(word: string): number {
  const plain = word.trim().replace(/[dD]/, 'e')
  if (/nan|ind/i.test(plain)) return Number.NaN
  if (/inf/i.test(plain)) return plain.startsWith('-') ? -Infinity : Infinity
  const [, mantissa, exponent] = /^([-+]?[\d.]+)([-+]\d+)$/.exec(plain) ?? []
  return plain === '' ? Number.NaN : Number(mantissa === undefined ? plain : `${mantissa}e${exponent}`)
}

function isSame(a: number, b: number): boolean {
  return Object.is(a, b) || (Number.isNaN(a) && Number.isNaN(b))
}

/** Reading a coordinate at its place gives its very bits. */
export function faultOfPlaces(places: CoordinatePlaces, points: Float64Array, bytes: Uint8Array): string | null {
  const decoder = new TextDecoder('latin1')
  if (places.kind === 'blocks') {
    const { blocks, type, isLittleEndian } = places
    const size = type === 'float32' ? 4 : 8
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    let i = 0
    for (const { count, from, stride } of blocks)
      for (let point = 0; point < count; ++point)
        for (const start of from) {
          const at = start + point * stride
          if (at < 0 || at + size > bytes.length) return `coordinate ${i} at byte ${at} beyond the file`
          const value = size === 4 ? view.getFloat32(at, isLittleEndian) : view.getFloat64(at, isLittleEndian)
          if (!isSame(value, points[i] as number)) return `coordinate ${i} is ${points[i]}, in the file ${value}`
          i++
        }
    return i === points.length ? null : `blocks for ${i} of ${points.length} coordinates`
  }
  if (places.kind === 'block') {
    const { from, type, isLittleEndian } = places
    const size = type === 'float32' ? 4 : 8
    if (from < 0 || from + size * points.length > bytes.length) return `a block from byte ${from} beyond the file`
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    for (let i = 0; i < points.length; ++i) {
      const at = from + size * i
      const value = size === 4 ? view.getFloat32(at, isLittleEndian) : view.getFloat64(at, isLittleEndian)
      if (!isSame(value, points[i] as number)) return `coordinate ${i} is ${points[i]}, in the file ${value}`
    }
    return null
  }
  if (places.kind === 'run') {
    const { from, to } = places
    if (!(from >= 0 && from <= to && to <= bytes.length)) return `a run of bytes ${from} to ${to} of ${bytes.length}`
    const words = decoder
      .decode(bytes.subarray(from, to))
      .split(/[\s,]+/)
      .filter(word => word !== '')
    if (words.length !== points.length) return `${words.length} words for ${points.length} coordinates`
    const bad = words.findIndex((word, i) => !isSame(doubleOf(word), points[i] as number))
    return bad < 0 ? null : `coordinate ${bad} is ${points[bad]}, in the file “${words[bad]}”`
  }
  const { from, lengths } = places
  if (from.length !== points.length || lengths.length !== points.length)
    return `${from.length} places for ${points.length} coordinates`
  for (let i = 0; i < points.length; ++i) {
    const [start, end] = [from[i] as number, (from[i] as number) + (lengths[i] as number)]
    if (!(start >= 0 && end > start && end <= bytes.length)) return `coordinate ${i} in bytes ${start} to ${end}`
    const word = decoder.decode(bytes.subarray(start, end))
    if (!isSame(doubleOf(word), points[i] as number)) return `coordinate ${i} is ${points[i]}, in the file “${word}”`
  }
  return null
}
