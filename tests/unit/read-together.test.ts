/** Files that are given together. */
import { expect, test } from 'vitest'
import { MissingFiles, readTogether } from '../../web/mesh/read-mesh'
import type { MeshFile } from '../../web/mesh/source'
import { unitCube } from './core-fixtures'
import { filesIn, sharedFile, textFile } from './mesh-expectations'
import { mshText } from './mesh-fixtures'

const read = (files: readonly MeshFile[]) => readTogether(files, { onProgress: () => {}, throwIfCancelled: () => {} })

function missing(files: readonly MeshFile[]): readonly string[] {
  try {
    read(files)
  } catch (error) {
    if (error instanceof MissingFiles) return error.names
    throw error
  }
  return []
}

const nodes = unitCube.flatMap((x, i) =>
  i % 3 === 0 ? [`${i / 3 + 1}, ${x}, ${unitCube[i + 1]}, ${unitCube[i + 2]}`] : [],
)
const included = textFile('Nodes.inp', `*NODE\n${nodes.join('\n')}\n`)
const including = textFile('a.inp', '*INCLUDE, INPUT=mesh\\nodes.inp\n*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n')

test('what another file names is a part of it, whichever comes first', () => {
  for (const files of [
    [included, including],
    [including, included],
  ]) {
    const meshes = read(files)
    expect(meshes.map(({ format, cells }) => `${format} ${cells.length / 8}`)).toEqual(['Abaqus 1'])
  }
})

test('a .pvtu and its pieces are one mesh, and pieces that are missing are asked for by name', () => {
  const files = filesIn('meshes/made/pvtu/').map(name => sharedFile(`meshes/made/pvtu/${name}`))
  const whole = files.filter(({ name }) => name.endsWith('.pvtu'))
  const pieces = files.filter(({ name }) => !name.endsWith('.pvtu'))
  expect([whole.length, pieces.length > 1]).toEqual([1, true])
  expect(read([...pieces, ...whole])).toHaveLength(1)
  expect(missing(whole).map(name => name.split('/').at(-1))).toEqual(pieces.map(({ name }) => name).toSorted())
  expect(missing([including])).toEqual(['mesh\\nodes.inp'])
})

test('files that do not belong together are a mesh each, and one that is refused refuses all', () => {
  const mesh = textFile('a.msh', mshText([unitCube]))
  expect(read([mesh, textFile('b.txt', unitCube.join(' '))])).toHaveLength(2)
  expect(() => read([mesh, textFile('b.txt', 'nothing')])).toThrow('b.txt: 0 numbers were found')
})
