/** One file read by the readers of web/mesh in a process of its own: prints the time it took and the memory beyond the start. */
import { readFileSync } from 'node:fs'
import { performance } from 'node:perf_hooks'
import { openMeshFile } from '../../web/cli/mesh-file'
import { loadReadingCore } from '../../web/core/reading-core'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { readMeshes } from '../../web/mesh/read-mesh'

/** Kilobytes, as Linux reports them. */
function memory(name: 'VmHWM' | 'VmRSS'): number {
  return Number(new RegExp(`${name}:\\s*(\\d+)`).exec(readFileSync('/proc/self/status', 'latin1'))?.[1])
}

const path = process.argv[2] as string
const core = await loadReadingCore(readFileSync(new URL('../hexlens-reading.wasm', import.meta.url)))
const hdf5 = /\.(?:exo|cgns|med|vtkhdf)$/.test(path) ? await hdf5Files() : null
const before = memory('VmRSS')
const { file, find, close } = await openMeshFile(path, process.stdin)
const begun = performance.now()
const [mesh] = readMeshes(file, { find, core, hdf5 })
const milliseconds = performance.now() - begun
close()
if (!mesh) throw new Error(`${path} has no mesh.`)
const { points, cells, ids } = mesh
const arrays = points.byteLength + cells.byteLength + (ids instanceof Float64Array ? ids.byteLength : 0)
console.log(
  JSON.stringify({
    milliseconds,
    megabytes: (memory('VmHWM') - before) / 1024,
    arrays: arrays / 2 ** 20,
    hexahedra: cells.length / 8,
  }),
)
