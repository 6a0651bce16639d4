/** `repair` as scripts meet it: what is written, what is said, the exit status, and that nothing else is touched. */
import { mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { checked } from './certificate-checker'
import { noisyGrid } from './grids'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-repair-'))
afterAll(() => rmSync(folder, { recursive: true }))
const pathOf = (name: string) => join(folder, name)

interface Varied {
  readonly boundarySigma?: number
  /** The order in which the nodes of a cell are listed. */
  readonly orderOf?: (cell: number) => readonly number[]
}

const IN_ORDER = [0, 1, 2, 3, 4, 5, 6, 7]

/** A Gmsh file of a noisy grid, with other cells and a comment that nobody reads. */
function gridFile(name: string, sigma: number, seed: number, { boundarySigma = 0, orderOf }: Varied = {}): string {
  const { points, cells } = noisyGrid(6, sigma, seed, boundarySigma)
  const nodes = Array.from(
    { length: points.length / 3 },
    (_, p) => `${p + 1} ${points.slice(3 * p, 3 * p + 3).join(' ')}`,
  )
  const hexahedra = Array.from(
    { length: cells.length / 8 },
    (_, c) => `${c + 1} 5 2 0 1 ${(orderOf?.(c) ?? IN_ORDER).map(v => (cells[8 * c + v] as number) + 1).join(' ')}`,
  )
  const text = `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n  as it  was\n$EndComments\n$Nodes\n${nodes.length}\n${nodes.join('\n')}
$EndNodes\n$Elements\n${hexahedra.length + 1}\n${hexahedra.join('\n')}\n900 15 2 0 1 1\n$EndElements\n`
  writeFileSync(pathOf(name), text)
  return pathOf(name)
}

async function run(...args: string[]) {
  let [output, errors] = ['', '']
  const status = await main(args, {
    input: (async function* () {})(),
    output: { write: text => (output += text) },
    errors: { write: text => (errors += text) },
  })
  return { status, output, errors }
}

const coordinates = (text: string) => text.slice(text.indexOf('$Nodes'), text.indexOf('$EndNodes'))

describe('repair', () => {
  it('writes the file with other coordinates only, which check accepts, and leaves its input', async () => {
    const input = gridFile('noisy.msh', 0.25, 1)
    const before = readFileSync(input, 'latin1')
    const output = pathOf('repaired.msh')
    expect((await run('check', input)).status).toBe(1)
    const { status, output: text, errors } = await run('repair', input, '-o', output, '--min-relative', '0.1')
    expect([status, errors]).toEqual([0, ''])
    expect(text).toMatch(
      /noisy\.msh \(Gmsh\) is written to .*, where every byte but those of coordinates is as it was\.\n/,
    )
    expect(text).toMatch(/Repaired: (\d+) of \1 invalid hexahedra, (\d+) of \2 below 0\.1\.\n/)
    expect(text).toMatch(/\d+ points have moved, by [\d.]+ at most and [\d.]+ on average\.\n/)
    expect(text).toContain('125 hexahedra, all VALID.')
    expect(readFileSync(input, 'latin1')).toBe(before)
    const after = readFileSync(output, 'latin1')
    expect(after.replace(coordinates(after), '')).toBe(before.replace(coordinates(before), ''))
    expect((await run('check', output, '--min-relative=0.1')).status).toBe(0)
  })

  it('writes another format where the name of the file is one of its', async () => {
    const output = pathOf('grid.inp')
    const { output: text } = await run('repair', gridFile('grid.msh', 0.05, 2), '-o', output)
    expect(text).toContain('its hexahedra alone, as Abaqus.')
    expect(readFileSync(output, 'latin1')).toMatch(/^\*/)
    expect((await run('check', output)).status).toBe(0)
  })

  it('writes the hexahedra as VTU where that is meant, says what holds the rest, and exits as check does', async () => {
    const output = pathOf('left.vtu')
    const { status, output: text } = await run(
      'repair',
      gridFile('hard.msh', 0.2, 2),
      '-o',
      output,
      '--min-relative=0.7',
      '--certificates',
      pathOf('left.json'),
    )
    expect(status).toBe(1)
    const proofs = JSON.parse(readFileSync(pathOf('left.json'), 'utf8'))
    expect(proofs.length).toBeGreaterThan(10)
    const held = /held at (\d+)/.exec(text)?.[1]
    expect(text).toContain(`left.json has certificates of ${proofs.length} of these ${held} points.`)
    expect(checked(JSON.stringify(proofs.slice(0, 6))).output).toBe('6 certificates hold\n')
    expect(proofs[0].name).toMatch(/^point \d+: vertex [0-7] of cell \d+$/)
    expect(text).toContain('its hexahedra alone, as VTU.')
    expect(text).toMatch(/What is left is held at \d+ points that may move \(counted from 0\):\n/)
    expect(text).toMatch(
      /point \d+ at \(.*\): no place makes its 8 cells better than [\d.]+, below 0\.7: \d points? of the cells/,
    )
    expect((await run('check', output, '--min-relative=0.7')).status).toBe(1)
  })

  it('repairs mirrored cells as if they were not, and writes them as they were, or exchanges their nodes', async () => {
    const isMirrored = (cell: number) => cell % 4 === 1
    const orderOf = (cell: number) => IN_ORDER.map(v => (isMirrored(cell) ? v ^ 4 : v))
    const mirrored = gridFile('mirrored.msh', 0.25, 1, { orderOf })
    const { output: plain } = await run('repair', gridFile('plain.msh', 0.25, 1), '-o', pathOf('plain-out.msh'))
    const kept = await run('repair', mirrored, '-o', pathOf('kept.msh'))
    const both = /Repaired: .*\n.* points have moved, by .*/
    expect([kept.status, kept.output.match(both)?.[0]]).toEqual([1, plain.match(both)?.[0]])
    expect(kept.output).toMatch(
      /\n {2}31 hexahedra are mirrored, .* written as they were; --reorder writes the hexahedra so, as VTU, VTK, Gmsh or Abaqus\.\n/,
    )
    const nodesOf = (name: string) => coordinates(readFileSync(pathOf(name), 'latin1'))
    expect(nodesOf('kept.msh')).toBe(nodesOf('plain-out.msh'))
    const { status, output } = await run('repair', mirrored, '-o', pathOf('right.vtu'), '--reorder')
    expect([status, output.match(both)?.[0]]).toEqual([0, plain.match(both)?.[0]])
    expect(output).toContain('  31 hexahedra were mirrored: nodes 0 to 3 and 4 to 7 are exchanged.\n')
    const refused = await run('repair', mirrored, '-o', pathOf('right.dat'), '--reorder')
    expect([refused.status, refused.errors]).toEqual([
      2,
      'hexlens: repair: In this file (Gmsh) the order of nodes cannot be replaced. Name a file that ends in one of .vtu, .vtk, .msh, .inp to write the hexahedra so.\n',
    ])
  })

  it('names the vertex of a certificate as the file lists it', async () => {
    const wanted = ['--min-relative=0.7', '--certificates', pathOf('vertices.json')]
    const turned = [4, 5, 6, 7, 0, 1, 2, 3]
    const names = async (...options: string[]) => {
      const input = gridFile('turned.msh', 0.2, 2, { orderOf: () => turned })
      await run('repair', input, '-o', pathOf('turned-out.msh'), ...wanted, ...options)
      return (JSON.parse(readFileSync(pathOf('vertices.json'), 'utf8')) as { name: string }[]).map(({ name }) => name)
    }
    const vertexOf = (name = '') => Number(/vertex (\d) of/.exec(name)?.[1])
    const [listed, reordered] = [await names(), await names('--reorder')]
    expect(listed.length).toBeGreaterThan(10)
    expect(listed.map(vertexOf)).toEqual(reordered.map(name => turned[vertexOf(name)]))
  })

  it('takes the order of all nodes in which all are valid', async () => {
    const lexicographic = gridFile('lexicographic.msh', 0.02, 5, { orderOf: () => [0, 1, 3, 2, 4, 5, 7, 6] })
    const kept = await run('repair', lexicographic, '-o', pathOf('order-kept.msh'))
    expect(kept.status).toBe(1)
    expect(kept.output).toMatch(/in the order “Lexicographic” .*\n {2}There was nothing else to repair\.\n/)
    const { status, output } = await run('repair', lexicographic, '-o', pathOf('order.inp'), '--reorder')
    expect(status).toBe(0)
    expect(output).toContain('in the order “Lexicographic” (deal.II, DOLFINx, VTK_VOXEL); they are written in that of')
  })

  it('reads another format with the options of its input, and what it has written without', async () => {
    const input = gridFile('steps.msh', 0.05, 6)
    await run('repair', input, '-o', pathOf('steps.vtu'))
    const sets = [0, 1].map(i => `<DataSet timestep="${i}" file="steps.vtu"/>`).join('')
    writeFileSync(pathOf('steps.pvd'), `<VTKFile type="Collection"><Collection>${sets}</Collection></VTKFile>`)
    expect((await run('repair', input, '-o', pathOf('named.vtu'), '--format=Gmsh')).status).toBe(0)
    expect((await run('repair', pathOf('steps.pvd'), '-o', pathOf('step.msh'), '--step=2')).status).toBe(0)
    const { status, errors } = await run('repair', pathOf('steps.pvd'), '-o', pathOf('step.msh'), '--step=3')
    expect([status, errors]).toEqual([2, 'hexlens: steps.pvd: it has 2 time steps, and step 3 was asked for.\n'])
  })

  it('frees the boundary as it is told', async () => {
    const input = gridFile('boundary.msh', 0.05, 3, { boundarySigma: 0.35 })
    const left = async (...options: string[]) => {
      await run('repair', input, '-o', pathOf('b.msh'), ...options)
      return Number(/(\d+) INVALID/.exec((await run('check', pathOf('b.msh'))).output)?.[1] ?? 0)
    }
    const fixed = await left()
    expect(fixed).toBeGreaterThan(3)
    expect(await left('--slide')).toBeLessThan(fixed)
    expect(await left('--free-boundary', '0.3')).toBeLessThan(fixed)
  })

  it('refuses a wrong call in a sentence, and leaves nothing behind', async () => {
    const input = gridFile('refused.msh', 0.1, 4)
    const before = readdirSync(folder)
    symlinkSync(input, pathOf('link.msh'))
    const said = async (...args: string[]) => {
      const { status, errors } = await run('repair', ...args)
      expect(status).toBe(2)
      return errors
    }
    expect(await said(input)).toContain('it wants -o and the file to write')
    expect(await said('-o', pathOf('x.msh'))).toContain('it wants one file')
    expect(await said(input, '-o', input)).toContain('stays as it is: name another file')
    expect(await said(input, '-o', pathOf('link.msh'))).toContain('stays as it is: name another file')
    expect(await said(input, '-o', '-')).toContain('not standard output')
    expect(await said(input, '-o', pathOf('x.msh'), '--certificates', '-')).toContain(
      'it writes certificates to a file',
    )
    for (const taken of [input, pathOf('x.msh')])
      expect(await said(input, '-o', pathOf('x.msh'), '--certificates', taken)).toContain('a file of their own')
    expect(await said(input, '-o', pathOf('none/x.msh'))).toContain('there is no such folder')
    expect(await said(input, '-o', pathOf('x.msh'), '--min-relative', '2')).toContain('a number from 0 to 1, not 2')
    expect(await said(input, '-o', pathOf('x.msh'), '--free-boundary=-1')).toContain('a distance, not -1')
    expect(await said(input, '-o', pathOf('x.msh'), '--slide=1')).toContain('--slide has no value')
    expect(await said(pathOf('missing.msh'), '-o', pathOf('x.msh'))).toContain('missing.msh')
    const text = readFileSync(input, 'latin1').replace(/^8 .*$/m, '8 nan 0 0')
    writeFileSync(pathOf('nan.msh'), text)
    expect(await said(pathOf('nan.msh'), '-o', pathOf('x.msh'))).toContain(
      'not a finite number. It is one of point 7, counted from 0.',
    )
    expect(readdirSync(folder).filter(name => !['link.msh', 'nan.msh'].includes(name))).toEqual(before)
  })

  it('says what it takes', async () => {
    const { status, output } = await run('repair', '--help')
    expect(status).toBe(0)
    for (const option of ['-o', '--min-relative', '--slide', '--free-boundary', '--step'])
      expect(output).toContain(option)
  })
})
