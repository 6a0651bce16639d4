/** Files of Node beside a mesh: however many there are, none stays open. */
import { mkdirSync, mkdtempSync, readdirSync, readlinkSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Readable } from 'node:stream'
import { afterAll, expect, it } from 'vitest'
import { openMeshFile } from '../../web/cli/mesh-file'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-'))
afterAll(() => rmSync(folder, { recursive: true }))

/** Files in the folder that this process has open. */
function openNow(): string[] {
  return readdirSync('/proc/self/fd').flatMap(descriptor => {
    try {
      const path = readlinkSync(`/proc/self/fd/${descriptor}`)
      return path.startsWith(folder) ? [path] : []
    } catch {
      return [] // the one that lists them
    }
  })
}

it('finds files beside a mesh, and holds only the mesh itself open', async () => {
  mkdirSync(join(folder, 'parts', 'empty'), { recursive: true })
  for (let i = 0; i < 60; ++i) writeFileSync(join(folder, 'parts', String(i)), `part ${i}`)
  writeFileSync(join(folder, 'mesh'), 'mesh')
  const { file, find, close } = await openMeshFile(join(folder, 'mesh'), Readable.from([]))
  const parts = Array.from({ length: 60 }, (_, i) => find(i % 2 ? `parts/${i}` : `parts\\${i}`))
  expect(openNow()).toEqual([join(folder, 'mesh')])
  const texts = parts.map(part => part && new TextDecoder().decode(part.read(5, part.size)))
  expect(texts).toEqual(parts.map((_, i) => String(i)))
  expect(new TextDecoder().decode(file.read(0, 4))).toBe('mesh')
  expect([find('parts/60'), find('parts/empty'), find('mesh/0')]).toEqual([null, null, null])
  rmSync(join(folder, 'parts', '7'))
  expect(() => parts[7]?.read(0, 1)).toThrow(/^7 cannot be read: /)
  close()
  expect(openNow()).toEqual([])
})
