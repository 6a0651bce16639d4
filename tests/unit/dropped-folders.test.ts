/** Folders that are dropped, with entries as browsers have them: so many at a time. */
import { expect, test } from 'vitest'
import { ofFolder, unfolded } from '../../web/input/dropped-folders'

const AT_ONCE = 2

function fileEntry(name: string, folder = '') {
  return {
    name,
    fullPath: `/${folder}${name}`,
    isFile: true,
    isDirectory: false,
    file: (done: (file: unknown) => void) => done({ name }),
  }
}

function folderEntry(name: string, entries: readonly object[], fails = false) {
  const createReader = () => {
    let at = 0
    return {
      readEntries(done: (some: readonly object[]) => void, fail: (reason: Error) => void) {
        if (fails) fail(new Error('not allowed'))
        else done(entries.slice(at, at + AT_ONCE))
        at += AT_ONCE
      },
    }
  }
  return { name, isFile: false, isDirectory: true, createReader }
}

function dropOf(entries: readonly object[]): DragEvent {
  return { dataTransfer: { items: entries.map(entry => ({ webkitGetAsEntry: () => entry })) } } as unknown as DragEvent
}

const given = { files: [{ name: 'folder' }] as unknown as File[] }

test('all files are found, in their order, whatever their depth', async () => {
  const inner = folderEntry('later', [fileEntry('a.vtu', 'case/later/'), fileEntry('.DS_Store')])
  const folder = folderEntry('case', [fileEntry('a.vtu', 'case/'), fileEntry('b.vtu', 'case/'), inner])
  const input = await unfolded(dropOf([fileEntry('a.pvd'), folder]), given)
  expect('files' in input && input.files.map(({ name }) => name)).toEqual(['a.pvd', 'a.vtu', 'b.vtu', 'a.vtu'])
  expect('files' in input && input.paths).toEqual(['a.pvd', 'case/a.vtu', 'case/b.vtu', 'case/later/a.vtu'])
})

test('a drop without folders stays as it is', () => {
  expect(unfolded(dropOf([fileEntry('a.vtu')]), given)).toBe(given)
  expect(unfolded(dropOf([]), { text: 'x' })).toEqual({ text: 'x' })
})

test('a folder that may not be read rejects', async () => {
  await expect(unfolded(dropOf([folderEntry('case', [], true)]), given)).rejects.toThrow('not allowed')
})

test('a folder that is opened has the paths of its files, and no hidden ones', () => {
  const files = ['case/0.1/w.vtu', 'case/.git/w.vtu', 'case/.DS_Store'].map(path => ({
    name: path.slice(path.lastIndexOf('/') + 1),
    webkitRelativePath: path,
  }))
  expect(ofFolder(files as File[])).toEqual({ files: [files[0]], paths: ['case/0.1/w.vtu'] })
})
