/**
 * Sweeps of best places over grids whose vertices were moved, natively in one thread; then Gmsh's untangler on one of them, which takes
 * minutes. HEXLENS_PYTHON names a python3 with numpy and gmsh; without one there is no peer. --quick: none either.
 */
import { execFileSync, spawnSync } from 'node:child_process'
import { cpus } from 'node:os'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** The grid of untangle.c that the peer gets: 8,000 cells with noise 0.2. */
const PEER_GRID = '3'

export async function main(options: readonly string[]): Promise<void> {
  execFileSync('make', ['-s', '-C', `${root}/wasm`, '../build/native/untangle', 'library'])
  console.log(`${cpus()[0]?.model}; CPU time of one thread`)
  execFileSync(`${root}/build/native/untangle`, { stdio: 'inherit' })
  if (options.includes('--quick')) return
  const input = execFileSync(`${root}/build/native/untangle`, [PEER_GRID], { maxBuffer: 2 ** 26 })
  const shared = execFileSync('find', [`${root}/build/native/library`, '-name', 'libhexlens.*so*', '-type', 'f'])
  const script = `${root}/tests/bench/repair_peer.py`
  const peer = spawnSync(process.env.HEXLENS_PYTHON ?? 'python3', [script, String(shared).trim()], { input })
  console.log(
    peer.status === 0 ? String(peer.stdout) : `without a peer: ${String(peer.stderr).trim().split('\n').at(-1)}`,
  )
}
