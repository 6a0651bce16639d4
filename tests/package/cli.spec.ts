/** `npx hexlens` as npm installs it. */
import { execFile } from 'node:child_process'
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { elsewhere, expect, root, test } from './elsewhere'

/** A Gmsh file of cubes beside each other; the last is upside down where that is wanted. */
function cubes(count: number, isLastMirrored: boolean): string {
  const corner = (i: number, y: number, z: number) => `${i} ${y} ${z}`
  const nodes = [0, 1].flatMap(z => [0, 1].flatMap(y => Array.from({ length: count + 1 }, (_, i) => corner(i, y, z))))
  const node = (i: number, y: number, z: number) => 1 + i + (count + 1) * (y + 2 * z)
  const cells = Array.from({ length: count }, (_, i) => {
    const layer = (z: number) => [node(i, 0, z), node(i + 1, 0, z), node(i + 1, 1, z), node(i, 1, z)]
    const isMirrored = isLastMirrored && i === count - 1
    return `${i + 1} 5 2 1 1 ${[...layer(isMirrored ? 1 : 0), ...layer(isMirrored ? 0 : 1)].join(' ')}`
  })
  const numbered = nodes.map((point, i) => `${i + 1} ${point}`)
  const section = (name: string, lines: string[]) => `$${name}\n${lines.length}\n${lines.join('\n')}\n$End${name}\n`
  return `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n${section('Nodes', numbered)}${section('Elements', cells)}`
}

async function hexlens(...args: string[]) {
  const { code, stdout, stderr } = await promisify(execFile)('npx', ['--no-install', 'hexlens', ...args], {
    cwd: elsewhere,
    maxBuffer: 2 ** 28,
  }).then(
    done => ({ ...done, code: 0 }),
    failed => failed,
  )
  return { code, stdout: String(stdout), stderr: String(stderr) }
}

test('hexlens check answers for meshes of few and of many cells, with its exit status', async () => {
  writeFileSync(join(elsewhere, 'few.msh'), cubes(3, false))
  writeFileSync(join(elsewhere, 'many.msh'), cubes(40_000, true))
  expect(await hexlens('check', 'few.msh')).toMatchObject({
    code: 0,
    stdout: expect.stringMatching(/^few\.msh \(Gmsh\): 3 hexahedra, all VALID\.\n/),
    stderr: '',
  })
  const { code, stdout, stderr } = await hexlens('check', '--json', '--worst', '1', 'many.msh', 'none.msh')
  expect([code, stderr]).toEqual([2, ''])
  const { files } = JSON.parse(stdout)
  expect(files[0]).toMatchObject({
    hexahedra: 40_000,
    valid: 39_999,
    worst: [{ id: '40000', class: 'inverted', boundary_min: -1 }],
  })
  expect(files[1].error).toMatch(/none\.msh cannot be read/)
})

test('hexlens check reads HDF5 by the file beside it', async () => {
  const files = ['zones.cgns', 'groups.med', 'parts.vtkhdf'].map(name => join(root, 'tests/unit/hdf5', name))
  const { stdout, stderr } = await hexlens('check', '--json', ...files)
  expect(stderr).toBe('')
  expect(JSON.parse(stdout).files.map(({ valid }: { valid: number }) => valid)).toEqual([6, 8, 3])
})

test('hexlens analyze answers for a list', async () => {
  const { code, stdout } = await hexlens('analyze', join(root, 'tests/vectors/public_cases.json'))
  expect(code).toBe(0)
  expect(JSON.parse(stdout).length).toBe(103)
})
