/** Folders that are dropped, with entries as browsers have them: so many at a time. */
import { expect, test } from 'vitest'
import { unfolded } from '../../web/input/dropped-folders'

const AT_ONCE = 2

function fileEntry(name: string) {
  return { name, isFile: true, isDirectory: false, file: (done: (file: unknown) => void) => done({ name }) }
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
  const inner = folderEntry('later', [fileEntry('c.vtu'), fileEntry('.DS_Store')])
  const folder = folderEntry('case', [fileEntry('a.vtu'), fileEntry('b.vtu'), inner, fileEntry('d.vtu')])
  const input = await unfolded(dropOf([fileEntry('a.pvd'), folder]), given)
  expect('files' in input && input.files.map(({ name }) => name)).toEqual(['a.pvd', 'a.vtu', 'b.vtu', 'c.vtu', 'd.vtu'])
})

test('a drop without folders stays as it is', () => {
  expect(unfolded(dropOf([fileEntry('a.vtu')]), given)).toBe(given)
  expect(unfolded(dropOf([]), { text: 'x' })).toEqual({ text: 'x' })
})

test('a folder that may not be read rejects', async () => {
  await expect(unfolded(dropOf([folderEntry('case', [], true)]), given)).rejects.toThrow('not allowed')
})
