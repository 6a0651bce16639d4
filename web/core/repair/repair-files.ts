/** The core for repairs as a file beside the page's scripts, fetched when it is first asked for. */
import wasmUrl from '../../../build/hexlens-repair.wasm?url'
import type { RepairCore } from './best-place'
import { loadRepairCore } from './repair-core'

export async function repairFiles(): Promise<RepairCore> {
  const response = await fetch(wasmUrl)
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
  return loadRepairCore(await response.arrayBuffer())
}
