/** Damage to files: of bytes, of tokens and lines, of tags and packed blocks. All of it comes from one seed and one number. */
import { gzipSync } from 'node:zlib'
import { randomSource } from '../unit/random'
import { type CorpusFile, corpus } from './corpus'

export interface Mutation {
  readonly number: number
  readonly path: string
  /** The time step that is read. */
  readonly step: number | 'last'
  /** The changes made, one after the other. */
  readonly steps: readonly string[]
  readonly name: string
  readonly bytes: Uint8Array
}

/** Most files are small; of a large one usually a part is read, so that all get their turn. */
const LARGE = 48_000
const MOST_STEPS = 4
/** Formats that are refused by their names: one of so many files of theirs is taken. */
const REFUSED = /bare\.h5$|\.diff$/
const OF_REFUSED = 6
/** One mutation of so many repeats a fragment to this many bytes. */
const REPEATS = 100
const LEAST_REPEATED = 100_000
const MOST_REPEATED = 300_000

export function mutationOf(seed: number, number: number): Mutation {
  const random = new Random(seed, number)
  let file = random.of(corpus)
  while (REFUSED.test(file.path) && random.below(OF_REFUSED) > 0) file = random.of(corpus)
  let bytes = file.bytes
  const steps: string[] = []
  if (bytes.length > LARGE && random.below(16) > 0) {
    bytes = bytes.subarray(0, 1000 + random.below(LARGE))
    steps.push('head')
  }
  for (let left = 1 + Math.min(random.below(MOST_STEPS), random.below(MOST_STEPS)); left > 0; --left) {
    const [name, damage] = random.of(DAMAGES)
    bytes = damage(bytes, random)
    steps.push(name)
  }
  if (random.below(REPEATS) === 0) {
    bytes = repeated(bytes, random)
    steps.push('repeat')
  }
  const step = random.below(4) > 0 ? 0 : random.of([1, 2, 'last'] as const)
  return { number, path: file.path, step, steps, name: nameFor(file, random), bytes }
}

class Random {
  readonly #next: () => number

  constructor(seed: number, number: number) {
    this.#next = randomSource(Math.imul(seed, 0x9e3779b1) ^ Math.imul(number + 1, 0x85ebca6b))
    for (let i = 0; i < 3; ++i) this.#next()
  }

  /** From 0 to count - 1. */
  below(count: number): number {
    return Math.floor(this.#next() * count)
  }

  of<T>(list: readonly T[]): T {
    return list[this.below(list.length)] as T
  }
}

type Damage = (bytes: Uint8Array, random: Random) => Uint8Array

const latin1 = new TextDecoder('latin1')
const textOf = (bytes: Uint8Array) => latin1.decode(bytes)
/** Characters of Latin 1 as bytes, others in UTF-8. */
const bytesOf = (text: string): Uint8Array => {
  const hasOthers = /[^\0-\xff]/.test(text)
  return new Uint8Array(Buffer.from(text, hasOthers ? 'utf8' : 'latin1'))
}

/** The bytes with [from, to) replaced. */
function spliced(bytes: Uint8Array, from: number, to: number, by: Uint8Array | string = ''): Uint8Array {
  const middle = typeof by === 'string' ? bytesOf(by) : by
  const whole = new Uint8Array(from + middle.length + bytes.length - to)
  whole.set(bytes.subarray(0, from))
  whole.set(middle, from)
  whole.set(bytes.subarray(to), from + middle.length)
  return whole
}

/** Numbers that counts, ids and coordinates are not, and words that they must not be. */
const TOKENS = [
  '0',
  '-1',
  '1',
  '8',
  '255',
  '65536',
  '2147483647',
  '2147483648',
  '-2147483649',
  '4294967295',
  '4294967296',
  '9007199254740993',
  '-9007199254740993',
  '18446744073709551616',
  '99999999999999999999999999',
  '1e15',
  '1e400',
  '-1e400',
  '1e-400',
  '4.9e-324',
  '1e99999999999',
  '1.5',
  '0.1000000000000000055511151231257827',
  '1.',
  '.5',
  '-.',
  '-',
  '+',
  'e',
  '1e',
  '1d3',
  '1.0-3',
  '1,5',
  '0x10',
  'nan',
  'NaN',
  '-nan(ind)',
  'inf',
  '-Infinity',
  '1.#QNAN',
  '...',
  '…',
  '50000001',
  '',
  'constructor',
  '__proto__',
  'hasOwnProperty',
  'undefined',
  'null',
  'true',
  '7'.repeat(500),
  `0.${'3'.repeat(5000)}`,
  '1'.repeat(20_000),
  'x'.repeat(5000),
  '\0',
  '\u202eabc\u202c',
  '\u001b[31mred',
  '"',
  '<',
  '&lt;',
  '&e;',
  ']]>',
  '*',
  '$',
  '#',
]

/** The range of some token near a random place; an empty range where there is none. */
function tokenNear(bytes: Uint8Array, random: Random, pattern = /[^\s<>"'=,;()[\]]+/g): [number, number] {
  const from = random.below(bytes.length)
  pattern.lastIndex = 0
  const match = pattern.exec(textOf(bytes.subarray(from, from + 2000)))
  if (match === null) return [from, from]
  // The first may have begun before.
  const next = pattern.exec(textOf(bytes.subarray(from, from + 2000))) ?? match
  const at = from + next.index
  return [at, at + next[0].length]
}

function someLines(bytes: Uint8Array, random: Random, most: number): [number, number] {
  const at = random.below(bytes.length)
  const from = at === 0 ? 0 : bytes.lastIndexOf(10, at - 1) + 1
  let to = from
  for (let left = 1 + random.below(most); left > 0 && to < bytes.length; --left) {
    const end = bytes.indexOf(10, to)
    to = end < 0 ? bytes.length : end + 1
  }
  return [from, to]
}

const INTEGERS = [0, 1, -1, 8, 12, 255, 65_536, 2 ** 31 - 1, -(2 ** 31), 2 ** 32 - 1, 10 ** 9] as const
const DOUBLES = [0, Number.NaN, Number.POSITIVE_INFINITY, 1e300, -1e-300, 2 ** 53, 1e15, 0.1] as const

function withNumber(bytes: Uint8Array, random: Random): Uint8Array {
  if (bytes.length < 16) return bytes
  const copy = bytes.slice()
  const view = new DataView(copy.buffer)
  const at = random.below(2) === 0 ? random.below(bytes.length - 8) : 4 * random.below((bytes.length - 8) / 4)
  const isLittleEndian = random.below(4) > 0
  const kind = random.below(3)
  if (kind === 0) view.setInt32(at, random.of(INTEGERS), isLittleEndian)
  else if (kind === 1)
    view.setBigInt64(at, BigInt(random.of([...INTEGERS, 2 ** 40, 2 ** 53, -(2 ** 62)])), isLittleEndian)
  else view.setFloat64(at, random.of(DOUBLES), isLittleEndian)
  return copy
}

function flipped(bytes: Uint8Array, random: Random): Uint8Array {
  const copy = bytes.slice()
  for (let left = 1 + random.below(6); left > 0; --left) {
    const at = random.below(copy.length)
    copy[at] = random.below(2) === 0 ? random.below(256) : (copy[at] as number) ^ (1 << random.below(8))
  }
  return copy
}

/** Mutated in the places that a pattern finds. */
function replaced(
  bytes: Uint8Array,
  random: Random,
  pattern: RegExp,
  by: (match: RegExpExecArray) => string,
): Uint8Array {
  const from = random.below(bytes.length)
  for (const start of [from, 0]) {
    const match = new RegExp(pattern.source, pattern.flags.replace('g', '')).exec(
      textOf(bytes.subarray(start, start + 4000)),
    )
    if (match !== null) return spliced(bytes, start + match.index, start + match.index + match[0].length, by(match))
  }
  return bytes
}

function base64Damage(run: string, random: Random): string {
  const at = random.below(run.length)
  const kind = random.below(5)
  if (kind === 0) return run.slice(0, at) + run.slice(at + 1 + random.below(5))
  if (kind === 1) return `${run.slice(0, at)}=${run.slice(at)}`
  if (kind === 2) return run.slice(0, at) + random.of(['A', '/', '-', '_', '\n', ' ', '*']) + run.slice(at + 1)
  if (kind === 3) return run.slice(0, at) + 'A'.repeat(4 * random.below(100)) + run.slice(at)
  return run + run
}

function gzipped(bytes: Uint8Array, random: Random): Uint8Array {
  const packed = new Uint8Array(gzipSync(bytes))
  const kind = random.below(8)
  if (kind === 0) packed[3] = random.below(256)
  else if (kind === 1) packed[packed.length - 1 - random.below(8)] = random.below(256)
  else if (kind === 2) return packed.subarray(0, random.below(packed.length))
  else if (kind === 3) return spliced(packed, packed.length, packed.length, packed)
  else if (kind === 4) return spliced(packed, packed.length, packed.length, new Uint8Array(random.below(2000)))
  else if (kind === 5) return flipped(packed, random)
  else if (kind === 6) return new Uint8Array(gzipSync(packed))
  return packed
}

const ENCODINGS: readonly ((text: string) => Uint8Array)[] = [
  text => new Uint8Array(Buffer.from(`\ufeff${text}`, 'utf16le')),
  text => new Uint8Array(Buffer.from(`\ufeff${text}`, 'utf16le').swap16()),
  text => new Uint8Array(Buffer.from(text, 'utf16le')),
  text => new Uint8Array(Buffer.from(`\ufeff${text}`, 'utf8')),
  text => new Uint8Array(Buffer.from(text.replace(/e/, '\u00e9'), 'utf8')),
  text => new Uint8Array(Buffer.from(text.replace(/ /g, '\u00a0'), 'utf8')),
]

function endingsOf(bytes: Uint8Array, random: Random): Uint8Array {
  const end = random.of(['\r\n', '\r', '\n\n', ' ', '\n ', '\u2028', ';\n', '\\\n'])
  return bytesOf(textOf(bytes).replaceAll('\n', end))
}

/** From a place in the bytes, fewer than `most`. */
function piece(bytes: Uint8Array, random: Random, most: number): Uint8Array {
  const from = random.below(bytes.length)
  return bytes.subarray(from, from + 1 + random.below(most))
}

const ODD_NAMES = ['\u202evtu.exe', '\u001b[2J', 'a'.repeat(400), '\u0000', '\u2028', '\ufeff', '\u200f"<&>'] as const

const DAMAGES: readonly (readonly [string, Damage])[] = [
  ['flip', flipped],
  ['cut', (bytes, random) => bytes.subarray(0, 1 + random.below(bytes.length))],
  ['behead', (bytes, random) => bytes.subarray(random.below(Math.min(bytes.length, 2000)))],
  [
    'drop',
    (bytes, random) => {
      const from = random.below(bytes.length)
      return spliced(bytes, from, Math.min(bytes.length, from + 1 + random.below(40)))
    },
  ],
  [
    'copy',
    (bytes, random) => {
      const at = random.below(bytes.length)
      return spliced(bytes, at, at, piece(bytes, random, 200))
    },
  ],
  [
    'token',
    (bytes, random) => {
      const [from, to] = tokenNear(bytes, random)
      return spliced(bytes, from, to, random.of(TOKENS))
    },
  ],
  [
    'tokens',
    (bytes, random) => {
      const token = random.of(TOKENS)
      let result = bytes
      for (let left = 5; left > 0; --left) {
        const [from, to] = tokenNear(result, random)
        result = spliced(result, from, to, token)
      }
      return result
    },
  ],
  [
    'count',
    (bytes, random) => {
      const [from, to] = tokenNear(bytes, random, /\b\d+\b/g)
      const count = Number(textOf(bytes.subarray(from, to)))
      const other = [count + 1, count - 1, 2 * count, 1000 * count, -count, Math.floor(count / 2)]
      return spliced(bytes, from, to, String(random.of(other)))
    },
  ],
  [
    'sign',
    (bytes, random) => {
      const [from] = tokenNear(bytes, random, /\b\d/g)
      return spliced(bytes, from, from, random.of(['-', '+', '.', ' ', ',', 'e', '\t', '1e', '"', '<', '>', '*', '$']))
    },
  ],
  [
    'drop lines',
    (bytes, random) => {
      const [from, to] = someLines(bytes, random, 6)
      return spliced(bytes, from, to)
    },
  ],
  [
    'double lines',
    (bytes, random) => {
      const [from, to] = someLines(bytes, random, 6)
      return spliced(bytes, from, from, bytes.slice(from, to))
    },
  ],
  [
    'move lines',
    (bytes, random) => {
      const [from, to] = someLines(bytes, random, 40)
      const block = bytes.slice(from, to)
      const rest = spliced(bytes, from, to)
      if (rest.length === 0) return bytes
      const [at] = someLines(rest, random, 1)
      return spliced(rest, at, at, block)
    },
  ],
  [
    'elide lines',
    (bytes, random) => {
      const [from, to] = someLines(bytes, random, 40)
      return spliced(bytes, from, to, random.of(['...\n', '[...]\n', '# ... 300 more\n', '\n\n', 'Hello,\n', '---\n']))
    },
  ],
  [
    'break line',
    (bytes, random) => {
      const [from] = tokenNear(bytes, random)
      return spliced(bytes, from, from, '\n')
    },
  ],
  [
    'join lines',
    (bytes, random) => {
      const end = bytes.indexOf(10, random.below(bytes.length))
      return end < 0 ? bytes : spliced(bytes, end, end + 1, ' ')
    },
  ],
  ['line ends', endingsOf],
  [
    'graft',
    (bytes, random) => {
      const other = random.of(corpus).bytes.subarray(0, LARGE)
      const [end] = someLines(other, random, 1)
      const [start] = someLines(bytes, random, 1)
      return spliced(bytes, 0, start, other.subarray(0, end))
    },
  ],
  ['append', (bytes, random) => spliced(bytes, bytes.length, bytes.length, random.of(corpus).bytes.subarray(0, LARGE))],
  [
    'quote',
    (bytes, random) => {
      const text = textOf(bytes)
      const kind = random.below(4)
      if (kind === 0) return bytesOf(text.replace(/^/gm, '> '))
      if (kind === 1) return bytesOf(`Hello,\n\n\`\`\`\n${text}\n\`\`\`\nwhat is wrong with it?\n`)
      return bytesOf(kind === 2 ? `~~~\n${text}` : `${text}\n\`\`\`\n`)
    },
  ],
  [
    'attribute',
    (bytes, random) =>
      replaced(bytes, random, /(\w+)="([^"]*)"/, ([, name, value = '']) => {
        const kind = random.below(4)
        if (kind === 0) return ''
        if (kind === 1) return `${name}="${random.of(TOKENS)}"`
        if (kind === 2) return `${name}="${value}${random.of(['0', '1', 'x', ' ', "'"])}"`
        return `${name}="${random.of(['Int8', 'UInt64', 'Float32', 'String', 'raw', 'base64', 'ascii', 'binary', 'appended', '3', '1', 'LittleEndian', 'BigEndian', 'vtkZLibDataCompressor', 'vtkLZ4DataCompressor', 'vtkLZMADataCompressor'])}"`
      }),
  ],
  ['tag', (bytes, random) => replaced(bytes, random, /<[^>]*>/, ([tag]) => (random.below(2) === 0 ? '' : tag + tag))],
  ['base64', (bytes, random) => replaced(bytes, random, /[A-Za-z0-9+/=]{24,}/, ([run]) => base64Damage(run, random))],
  ['number', withNumber],
  [
    'numbers',
    (bytes, random) => {
      let result = bytes
      for (let left = 4; left > 0; --left) result = withNumber(result, random)
      return result
    },
  ],
  [
    'words turned round',
    (bytes, random) => {
      const copy = bytes.slice()
      const from = 4 * random.below(bytes.length / 4)
      const to = Math.min(copy.length - 3, from + 4 * random.below(200))
      for (let at = from; at < to; at += 4) copy.subarray(at, at + 4).reverse()
      return copy
    },
  ],
  ['encoding', (bytes, random) => random.of(ENCODINGS)(textOf(bytes))],
  ['gzip', gzipped],
  [
    'name',
    (bytes, random) =>
      replaced(bytes, random, /"[^"\n]{1,40}"|=\s*\w{2,}|\b[A-Za-z]{4,}\b/, ([word]) =>
        word.replace(/\w+/, random.of(ODD_NAMES)),
      ),
  ],
]

/** Texts that were slow once, and others like them. */
export const FRAGMENTS = [
  'p 1 2 3 ',
  '[',
  '(',
  '{',
  ';',
  '...',
  '... ',
  '...\n',
  'double a[',
  '/* ',
  '*/',
  '// ',
  '# ',
  '"',
  "'",
  '\\',
  '<',
  '<!--',
  '<a>',
  '<![CDATA[',
  '&amp;',
  '1 ',
  '1',
  '-',
  ', ',
  ',',
  '\n',
  '\r',
  '\t',
  ' ',
  '> ',
  '>',
  '```\n',
  '`',
  '~~~\n',
  'x = [',
  '[[[',
  ']',
  '}',
  '[1,',
  '{"a":',
  '"a":[1,2,3],',
  '1 2 3\n',
  '0 0 0;',
  'a=1;',
  '$Nodes\n',
  '*NODE\n',
  '*NODE,',
  '*INSTANCE,NAME=a',
  'GRID,1,,0.,0.,0.\n',
  'GRID    ',
  '+',
  '&',
  '% ',
  'e',
  '.',
  '1e',
  'elem ',
  'Elem Information\n',
  'Node id()=',
  'v 0 0 0\n',
  'f 1 2 3\n',
  'POINTS 1 double\n',
  'CELLS 1 9\n',
  '# vtk DataFile Version 3.0\n',
  'Vertices\n8\n',
  'MFEM mesh v1.0\n',
  'hex (0 1 2 3 4 5 6 7) ',
  '\\begin{tabular}',
  ' & ',
  '\\\\\n',
  'Begin Nodes\n',
  'ZONE ',
  '    -1\n',
  'array([',
  'nan ',
  '\0',
  '\u00e9',
  '\u2026',
] as const

/** The fragment again and again, up to this size. */
export function filled(fragment: Uint8Array, size: number): Uint8Array {
  const many = new Uint8Array(size)
  for (let at = 0; at < size; at += fragment.length) many.set(fragment.subarray(0, size - at), at)
  return many
}

function repeated(bytes: Uint8Array, random: Random): Uint8Array {
  const fragment = random.below(3) === 0 && bytes.length > 0 ? piece(bytes, random, 40) : bytesOf(random.of(FRAGMENTS))
  const many = filled(fragment, LEAST_REPEATED + random.below(MOST_REPEATED - LEAST_REPEATED))
  if (random.below(2) === 0) return many
  const head = bytes.subarray(0, LARGE)
  const [at] = head.length === 0 ? [0] : someLines(head, random, 1)
  return spliced(head, at, at, many)
}

function nameFor(file: CorpusFile, random: Random): string {
  const kind = random.below(20)
  if (kind === 0) return random.of(corpus).name
  if (kind === 1) return 'paste'
  if (kind === 2) return `${random.of(ODD_NAMES)}${file.name}`
  return file.name
}
