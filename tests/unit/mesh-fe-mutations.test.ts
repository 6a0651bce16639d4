/** Whatever is done to a file of these formats, it ends in a mesh or in a sentence, and soon. */
import { expect, it } from 'vitest'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { randomSource } from './core-fixtures'
import { filesIn, sharedFile } from './mesh-expectations'

const PER_FILE = 40
const MOST_MILLISECONDS = 2000

const files = [
  ...filesIn('meshes/made/').map(name => `meshes/made/${name}`),
  ...filesIn('pastes/').map(name => `pastes/${name}`),
  'meshes/real/sector.cdb',
].filter(path => /\.(?:inp|bdf|nas|cdb|key|k)$/.test(path) && !path.includes('ucd'))

const generators = new TextEncoder().encode(
  '*NODE,NSET=A\n1,0,0,0\n2,1,0,0\n*NGEN,NSET=B\n1,2\n*NSET,NSET=C,GENERATE\n1,9,2\n*NFILL\nA,A,2,9\n*NCOPY,OLD SET=A,CHANGE NUMBER=9,SHIFT\n1,1,1\n0,0,0,0,0,1,90\n*ELEMENT,TYPE=C3D8,ELSET=E\n1,1,2,1,2,1,2,1,2\n*ELGEN,ELSET=E\n1,9,1,1,9,9,9\n*ELSET,ELSET=F,GENERATE\n1,99999999999\n*ELCOPY,OLD SET=F,ELEMENT SHIFT=9,SHIFT NODES=1\n',
)

function mutated(bytes: Uint8Array, random: () => number): Uint8Array {
  const copy = Array.from(bytes)
  const place = () => Math.floor(random() * copy.length)
  for (let change = 0; change < 3; ++change) {
    const at = place()
    const what = Math.floor(random() * 7)
    if (what === 0) copy[at] = Math.floor(random() * 256)
    else if (what === 1) copy.splice(at, 1 + Math.floor(random() * 20))
    else if (what === 2) copy.splice(at, 0, ...copy.slice(place()).slice(0, 40))
    else if (what === 3) copy.length = Math.max(1, at)
    else if (what === 4) copy.splice(at, 0, 57, 57, 57, 57, 57, 57, 57)
    else if (what === 5) copy.splice(at, 0, 44)
    else copy.splice(at, 0, 10)
  }
  return Uint8Array.from(copy)
}

it.each([...files, 'generators.inp'])('reads mutations of %s', path => {
  const random = randomSource(path.length)
  const file = path === 'generators.inp' ? fileOfBytes(path, generators) : sharedFile(path)
  const bytes = file.read(0, Math.min(file.size, 40_000))
  for (let i = 0; i < PER_FILE; ++i) {
    const start = performance.now()
    try {
      const [mesh] = readMeshes(fileOfBytes(file.name, mutated(bytes, random)))
      for (const index of mesh?.cells ?? [])
        if (3 * index >= (mesh?.points.length ?? 0)) throw new Error(`index ${index}`)
    } catch (error) {
      if (!(error instanceof MeshRefusal)) throw new Error(`mutation ${i}: ${(error as Error).stack}`)
      expect(error.message).not.toMatch(/undefined|NaN/)
    }
    expect(performance.now() - start, `mutation ${i}`).toBeLessThan(MOST_MILLISECONDS)
  }
})
