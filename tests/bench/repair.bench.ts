/**
 * Sweeps of best places over grids whose vertices were moved, natively in one thread; then peers on some of them: Gmsh's untangler, which
 * takes minutes, and TMOP of PyMFEM. HEXLENS_PYTHON names a python3 with numpy and gmsh or mfem; what is missing is left out.
 * --quick: no peers.
 */
import { execFileSync, spawnSync } from 'node:child_process'
import { cpus } from 'node:os'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** Grids of untangle.c that peers get, 8,000 cells each: noise 0.2 and 0.3, 10, 30 and 50 % thrown, twisted, folded. */
const PEERS = [
  { name: "Gmsh's untangler", script: 'repair_peer.py', grids: [3] },
  { name: 'TMOP', script: 'tmop_peer.py', grids: [3, 4, 5, 7, 9, 10, 11] },
]

export async function main(options: readonly string[]): Promise<void> {
  execFileSync('make', ['-s', '-C', `${root}/wasm`, '../build/native/untangle', 'library'])
  console.log(`${cpus()[0]?.model}; CPU time of one thread`)
  execFileSync(`${root}/build/native/untangle`, { stdio: 'inherit' })
  if (options.includes('--quick')) return
  const shared = execFileSync('find', [`${root}/build/native/library`, '-name', 'libhexlens.*so*', '-type', 'f'])
  for (const { name, script, grids } of PEERS)
    for (const grid of grids) {
      const input = execFileSync(`${root}/build/native/untangle`, [String(grid)], { maxBuffer: 2 ** 26 })
      const words = [`${root}/tests/bench/${script}`, String(shared).trim()]
      const peer = spawnSync(process.env.HEXLENS_PYTHON ?? 'python3', words, { input })
      if (peer.status !== 0) {
        console.log(`without ${name}: ${String(peer.stderr).trim().split('\n').at(-1)}`)
        break
      }
      console.log(`grid ${grid}: ${String(peer.stdout).trim().split('\n').at(-1)}`)
    }
}
