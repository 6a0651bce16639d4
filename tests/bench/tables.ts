/** The rows of the sweep as text and as Markdown. */

export interface Row {
  readonly query: 'validity' | 'minimum'
  readonly target: 'native' | 'wasm'
  readonly sigma: number
  readonly elements: number
  readonly roots_ns: number
  readonly roots_b_ns: number
  readonly hexlens_ns: number
  readonly invalid: number
  /** Left open by the lanes; left open by doubles as well, and decided in exact arithmetic. */
  readonly after_lanes: number
  readonly undecided: number
  readonly disagreements: number
  /** For comparison: a scalar loop over twenty determinants, the lanes alone, reading alone. */
  readonly determinants_ns: number
  readonly lanes_ns: number
  readonly loads_ns: number
}

export interface About {
  readonly machine: string
  readonly compiler: string
  readonly vectors: string
  readonly node: string
  readonly elements: number
  readonly trials: number
}

/** Gmsh's minDetJac by sigma, in nanoseconds an element. */
export type GmshTimes = ReadonlyMap<number, number>

const PARTS = [
  ['validity', 'native'],
  ['validity', 'wasm'],
  ['minimum', 'native'],
  ['minimum', 'wasm'],
] as const

function sentence({ machine, compiler, vectors, node, elements, trials }: About): string {
  return `${machine}; ${compiler}, vectors: ${vectors}; Node ${node}. Nanoseconds of CPU time an element, medians of ${trials} trials with rotated order, ${elements.toLocaleString('en')} elements a row. Disagreements: verdicts that exact arithmetic, asked wherever Roots+B and Hexlens differ, does not confirm; minima that differ by more than 1e-9; bits that native and wasm do not share.`
}

function header(query: Row['query'], gmsh: GmshTimes | null): string[] {
  return [
    'sigma',
    'invalid',
    'Roots',
    'Roots+B',
    'Hexlens',
    'Roots+B / Hexlens',
    'after lanes',
    'undecided',
    'disagreements',
    '20 determinants',
    'lanes alone',
    'reading alone',
    ...(gmsh && query === 'minimum' ? ['Gmsh minDetJac'] : []),
  ]
}

function cells(row: Row, gmsh: GmshTimes | null): string[] {
  return [
    row.sigma.toFixed(1),
    String(row.invalid),
    row.roots_ns.toFixed(0),
    row.roots_b_ns.toFixed(0),
    row.hexlens_ns.toFixed(1),
    (row.roots_b_ns / row.hexlens_ns).toFixed(1),
    String(row.after_lanes),
    String(row.undecided),
    String(row.disagreements),
    row.determinants_ns.toFixed(0),
    row.lanes_ns.toFixed(1),
    row.loads_ns.toFixed(1),
    ...(gmsh && row.query === 'minimum' ? [gmsh.get(row.sigma)?.toFixed(0) ?? ''] : []),
  ]
}

function parts(rows: readonly Row[], gmsh: GmshTimes | null): { title: string; head: string[]; body: string[][] }[] {
  return PARTS.map(([query, target]) => ({
    title: `${query === 'validity' ? 'Validity' : 'Boundary minimum'}, ${target === 'native' ? 'native' : 'WebAssembly'}`,
    head: header(query, gmsh),
    body: rows.filter(row => row.query === query && row.target === target).map(row => cells(row, gmsh)),
  }))
}

export function text(about: About, rows: readonly Row[], gmsh: GmshTimes | null): string {
  const tables = parts(rows, gmsh).map(({ title, head, body }) => {
    const line = (words: readonly string[]) =>
      words.map((word, i) => word.padStart((head[i] as string).length)).join('  ')
    return [title, line(head), ...body.map(line)].join('\n')
  })
  return [sentence(about), ...tables].join('\n\n')
}

export function markdown(about: About, rows: readonly Row[], gmsh: GmshTimes | null): string {
  const line = (words: readonly string[]) => `| ${words.join(' | ')} |`
  const tables = parts(rows, gmsh).map(({ title, head, body }) =>
    [`### ${title}`, '', line(head), line(head.map(() => '---:')), ...body.map(line)].join('\n'),
  )
  return [
    sentence(about),
    '![Nanoseconds an element against sigma, for the three methods](benchmarks.svg)',
    ...tables,
  ].join('\n\n')
}
