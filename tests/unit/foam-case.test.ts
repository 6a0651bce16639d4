/** An OpenFOAM case that is dropped as a folder: its mesh is read, and its other files are named. */
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { foamCaseOf } from '../../web/mesh/foam-case'
import { readTogether } from '../../web/mesh/read-mesh'
import type { MeshFile } from '../../web/mesh/source'
import { stepFilesOf } from '../../web/mesh/step-files'
import { textFile } from './mesh-expectations'
import { FOAM } from './other-formats'

const OPTIONS = { onProgress: () => {}, throwIfCancelled: () => {} }

function at(path: string, text: string): MeshFile {
  return { ...textFile(path.slice(path.lastIndexOf('/') + 1), text), path }
}

const polyMesh = (folder: string, location = 'constant/polyMesh') =>
  Object.entries(FOAM).map(([name, text]) => at(`${folder}/${name}`, text.replaceAll('constant/polyMesh', location)))
const field = (path: string) =>
  at(
    path,
    'FoamFile\n{\n    format ascii;\n    class volVectorField;\n    object U;\n}\ninternalField uniform (0 0 0);\n',
  )
const dictionary = (path: string) =>
  at(path, 'FoamFile\n{\n    format ascii;\n    class dictionary;\n}\nstartTime 0;\n')
const others = (root: string) => [
  field(`${root}/0/U`),
  dictionary(`${root}/constant/transportProperties`),
  dictionary(`${root}/system/controlDict`),
  at(`${root}/Allrun`, '#!/bin/sh\n'),
]
const cellsOf = (files: readonly MeshFile[]) => readTogether(files, OPTIONS).map(({ cells }) => cells.length / 8)

test('the mesh of a case is read, and one note names what is no part of it', () => {
  const files = [...others('case'), ...polyMesh('case/constant/polyMesh'), field('case/constant/polyMesh/sets/left')]
  const [mesh, ...more] = readTogether(files, OPTIONS)
  expect(more).toEqual([])
  expect(mesh?.cells.length).toBe(8 * 64)
  expect(mesh?.notes.filter(note => /case/.test(note))).toEqual([
    'Of the OpenFOAM case the mesh is read; 5 files are no part of it: “0/U”, “constant/transportProperties”, “system/controlDict” and 2 more.',
  ])
  expect(stepFilesOf(files, OPTIONS)).toBeNull()
})

test.each(['polyMesh', 'constant/polyMesh', 'a/b/constant/polyMesh'])('its folder %s alone', folder => {
  const files = [...polyMesh(folder), at('beside.txt', '0 0 0')]
  const { files: read, note } = foamCaseOf(files) ?? { files: [], note: '' }
  expect(read.map(({ name }) => name)).toEqual([...Object.keys(FOAM), 'beside.txt'])
  expect(note).toBeNull()
  expect(cellsOf(polyMesh(folder))).toEqual([64])
})

test('parts of a decomposed case, and meshes of later times, are not read beside the mesh itself', () => {
  const copies = [
    ...polyMesh('case/processor0/constant/polyMesh'),
    ...polyMesh('case/processor1/constant/polyMesh'),
    ...polyMesh('case/0.5/polyMesh', '0.5/polyMesh'),
  ]
  const own = polyMesh('case/constant/polyMesh')
  expect(foamCaseOf([...copies, ...own])?.files).toEqual(own)
  // Without it they are what there is.
  const parts = copies.filter(({ path = '' }) => path.includes('processor'))
  expect(cellsOf([...parts, ...others('case')])).toEqual([64, 64])
})

test('regions are meshes of one case', () => {
  const regions = ['fluid', 'solid'].flatMap(name =>
    polyMesh(`case/constant/${name}/polyMesh`, `constant/${name}/polyMesh`),
  )
  expect(cellsOf([...regions, ...others('case')])).toEqual([64, 64])
})

test('the case of ../shared with fields beside its mesh', () => {
  const shared = new URL('../../../shared/meshes/made/foam/constant/polyMesh/', import.meta.url)
  const files = ['boundary', 'faces', 'neighbour', 'owner', 'points'].map(name =>
    at(`foam/constant/polyMesh/${name}`, readFileSync(new URL(name, shared), 'latin1')),
  )
  expect(cellsOf([...others('foam'), ...files])).toEqual([4])
})

test('files that are in no folder of a mesh are as they were', () => {
  expect(foamCaseOf([field('case/0/U'), dictionary('case/system/controlDict')])).toBeNull()
  expect(foamCaseOf([at('faces', ''), at('polyMesh/points', '')])).toBeNull()
})
