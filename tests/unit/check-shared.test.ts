/** `check` on every file of ../shared/meshes and ../shared/pastes; each test lists the files that it does not answer as it should. */
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { openMeshFile } from '../../web/cli/mesh-file'
import { joined } from '../../web/mesh/join-meshes'
import { readMeshes } from '../../web/mesh/read-mesh'
import { verticesOf } from '../../web/mesh/vertices-of'

const shared = fileURLToPath(new URL('../../../shared/', import.meta.url))
const manifest = (name: string) => JSON.parse(readFileSync(`${shared}${name}`, 'utf8'))

/** The formats of a later list: these are refused, by name. */
const LATER_FORMATS = new Set(['diffpack', 'matlab'])
const NOT_KNOWN = /in no format that is known here/

interface Cell {
  readonly id: string | null
  readonly index: number
  readonly valid: boolean | null
  readonly boundary_min: number
}

interface Checked {
  readonly status: number
  readonly file: {
    readonly error?: string
    readonly hexahedra: number
    readonly valid: number
    readonly invalid: number
    readonly unanswered: number
    readonly not_trilinear: { readonly count: number; readonly valid_by_corners: number }
    readonly other: Readonly<Record<string, number>>
    readonly notes: readonly string[]
    readonly worst: readonly Cell[]
  }
}

async function check(path: string): Promise<Checked> {
  let output = ''
  const streams = {
    input: (async function* () {})(),
    output: { write: (text: string) => (output += text) },
    errors: { write: () => {} },
  }
  const status = await main(['check', '--json', '--worst', 'all', path], streams)
  return { status, file: JSON.parse(output).files[0] }
}

/** Fails with the complaints about the files, by name, if there are any. */
async function expectNone<T extends { readonly file: string }>(
  files: readonly T[],
  problemOf: (one: T) => Promise<string | null>,
) {
  const failing: string[] = []
  for (const one of files) {
    const problem = await problemOf(one).catch(error => `it throws: ${error.message}`)
    if (problem !== null) failing.push(`${one.file}: ${problem}`)
  }
  expect(failing).toEqual([])
}

/** The difference, or null. */
function differing(found: object, expected: object): string | null {
  const [a, b] = [JSON.stringify(found), JSON.stringify(expected)]
  return a === b ? null : `${a} in place of ${b}`
}

interface Made {
  readonly file: string
  readonly format: string
  readonly counts: Readonly<Record<string, number>>
  readonly hexes: string
  readonly coordinates_exact?: boolean
}

interface Bracket {
  readonly valid: boolean
  readonly min_lower: number
  readonly min_upper: number
}

/** meshio leaves all but triangles, tetrahedra and lines out of this one: nothing is in it to be answered. */
const ONLY_TETRAHEDRA = 'meshio.h5m'

/** Gmsh leaves the pyramid out of these. */
const NO_PYRAMID = new Set(['gmsh.unv', 'gmsh.key', 'gmsh.rad'])

/** meshio turns the mirrored one round when it writes this file. */
const UPRIGHT: Readonly<Record<string, number>> = { 'meshio.f3grid': 2 }

/** Gmsh prints six digits here, which changes the thin element's minimum. */
const SIX_DIGITS = new Set(['gmsh.rad'])

/** Some writers print twelve digits and call that exact. */
const ROUNDING = 1e-8

it('made', async () => {
  const { linear, files }: { linear: Bracket[]; files: Made[] } = manifest('meshes/made/manifest.json')
  await expectNone(files, async ({ file: name, format, counts, hexes, coordinates_exact }) => {
    const path = name === 'pvtu' ? 'pvtu/mesh.pvtu' : name
    const { status, file } = await check(`${shared}meshes/made/${path}`)
    if (file.error !== undefined)
      return LATER_FORMATS.has(format) && status === 2 && !NOT_KNOWN.test(file.error) ? null : file.error
    if (name === ONLY_TETRAHEDRA) return differing([status, file.other], [3, { tetrahedron: counts.tetra }])
    const { hexahedron = 0, voxel = 0, tetra = 0, quad = 0, wedge = 0, pyramid = 0, polyhedron = 0 } = counts
    const expected = {
      hexahedra: hexahedron + voxel,
      notTrilinear: (counts.hexahedron20 ?? 0) + (counts.lagrange2 ?? 0),
      other: [tetra, wedge, NO_PYRAMID.has(name) ? 0 : pyramid, quad, polyhedron],
    }
    const { tetrahedron = 0, quadrilateral = 0, ...others } = file.other
    const found = {
      hexahedra: file.hexahedra,
      notTrilinear: file.not_trilinear.count,
      other: [tetrahedron, others.wedge ?? 0, others.pyramid ?? 0, quadrilateral, others.polyhedron ?? 0],
    }
    const sum = found.hexahedra + found.other.reduce((a, b) => a + b, 0)
    if (counts.eblock !== undefined) return differing({ all: sum }, { all: counts.eblock })
    const wrongCounts = differing(found, expected)
    if (wrongCounts !== null || !hexes.startsWith('linear')) return wrongCounts
    const cells = file.worst.toSorted((a, b) => a.index - b.index).filter((_, i) => i < hexahedron)
    const wrong = cells.filter(({ valid, boundary_min }, i) => {
      const { valid: isValid, min_lower, min_upper } = linear[i % linear.length] as Bracket
      if (UPRIGHT[name] === i) return valid !== true
      const isExact = coordinates_exact !== false && !SIX_DIGITS.has(name)
      return (
        valid !== isValid ||
        (isExact && !(boundary_min >= min_lower - ROUNDING && boundary_min <= min_upper + ROUNDING))
      )
    })
    if (wrong.length > 0) return `other answers for the hexahedra ${wrong.map(({ index }) => index)}`
    return status === 1 ? null : `exit status ${status}`
  })
})

/** Counts by file: hexahedra, valid, not trilinear, valid by corners. */
const REAL: Readonly<Record<string, readonly [number, number, number, number]>> = {
  'matrix_fiber_rand.vtk': [603, 506, 0, 0],
  'rockerarm.mesh': [10_600, 10_600, 0, 0],
  'cylinder-hex.mesh': [252, 252, 0, 0],
  'mesh_hex.msh': [150, 150, 0, 0],
  // Its README speaks of 20 nodes; the file has SOLID185, eight nodes each, four of them degenerate.
  'sector.cdb': [105, 101, 0, 0],
  'rot063akd2s_107.bdf': [2400, 2400, 0, 0],
  '8-block.g': [64, 64, 0, 0],
  'fichera-mixed-p2.vtk': [0, 0, 3, 3],
}

it('real', async () => {
  const files = readdirSync(`${shared}meshes/real`).map(file => ({ file }))
  await expectNone(files, async ({ file: name }) => {
    const { file } = await check(`${shared}meshes/real/${name}`)
    const expected = REAL[name]
    if (file.error !== undefined) return expected || NOT_KNOWN.test(file.error) ? file.error : null
    const { hexahedra, valid, not_trilinear } = file
    const found = [hexahedra, valid, not_trilinear.count, not_trilinear.valid_by_corners]
    return differing(found, expected ?? [])
  })
})

it('malformed', async () => {
  const files: { file: string; expect: string }[] = manifest('meshes/malformed/manifest.json')
  await expectNone(files, async ({ file: name, expect: wanted }) => {
    const { status, file } = await check(`${shared}meshes/malformed/${name}`)
    const isRefused = status === 2 && file.error !== undefined && !/\n/.test(file.error)
    const isNamed = isRefused && (name === 'not-a-mesh.vtu' || !NOT_KNOWN.test(file.error ?? ''))
    const isNoted = !isRefused && (file.notes ?? []).length > 0
    const answer = `${status} ${file.error ?? file.notes.join(' ')}`
    const right: Readonly<Record<string, boolean>> = {
      'inf.vtu': status === 3 && file.unanswered === 1,
      'nan-unused.vtu': status === 0 && file.valid === 1,
      'vtk-one-point.vtk': status === 3 && file.hexahedra === 0,
      'vtk-type11-as-hex.vtk': isNamed || isNoted,
      'msh-sparse-ids.msh': status === 0 && file.worst?.[0]?.id === '7' && file.worst[0].boundary_min === 1,
      'medit-2d.mesh': isNamed || (status === 3 && file.hexahedra === 0),
    }
    const isRight = right[name] ?? (isNamed || (/\bor (note|read)/.test(wanted) && isNoted))
    return isRight ? null : `${wanted}; answered ${answer}`
  })
})

interface Paste {
  readonly file: string
  readonly hexahedra: number | null
  readonly invalid: number | null
  readonly exit: readonly number[]
  readonly expect: readonly (readonly [string, readonly number[]])[] | null
}

it('pastes', async () => {
  await expectNone<Paste>(manifest('pastes/expected.json'), async paste => {
    const path = `${shared}pastes/${paste.file}`
    const { status, file } = await check(path)
    if (!paste.exit.includes(status))
      return `exit status ${status} in place of ${paste.exit}: ${file.error ?? file.notes.join(' ')}`
    if (file.error !== undefined) return null
    if (paste.hexahedra !== null && file.hexahedra !== paste.hexahedra && status !== 3)
      return `${file.hexahedra} hexahedra in place of ${paste.hexahedra}`
    if (paste.invalid !== null && status !== 3 && file.invalid !== paste.invalid)
      return `${file.invalid} invalid in place of ${paste.invalid}`
    if (paste.expect === null) return null
    const { file: opened, find, close } = await openMeshFile(path, (async function* () {})())
    const [first, ...others] = readMeshes(opened, { find })
    close()
    if (!first) return 'no mesh'
    const mesh = joined([first, ...others])
    const wrong = paste.expect.filter(([, vertices], cell) => !areAlike(verticesOf(mesh, cell), vertices))
    return wrong.length > 0 ? `other coordinates for ${wrong.map(([name]) => name)}` : null
  })
})

/** True if equal to six digits, as logs print, up to a translation of the whole instance. */
function areAlike(found: readonly number[], expected: readonly number[]): boolean {
  return found.every((x, i) => {
    const difference = x - (found[i % 3] as number) - ((expected[i] as number) - (expected[i % 3] as number))
    return Math.abs(difference) <= 1e-5
  })
}

it('texts that were slow or endless', async () => {
  const files = ['min-oneline.txt', 'min-semicolons.txt', 'min-deep.json'].map(file => ({ file }))
  await expectNone(files, async ({ file }) => {
    const started = performance.now()
    const { status, file: answer } = await check(`${shared}pastes/${file}`)
    const seconds = (performance.now() - started) / 1000
    return seconds < 5 && (status !== 2 || answer.error) ? null : `${status} after ${seconds} s`
  })
})
