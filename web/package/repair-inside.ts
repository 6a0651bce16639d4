/** The core for repairs inside one file. */
import base64 from 'virtual:hexlens-repair.wasm.deflated'
import type { RepairCore } from '../core/repair/best-place'
import { loadRepairCore } from '../core/repair/repair-core'
import { inflated } from './inflate'

export async function repairInside(): Promise<RepairCore> {
  return loadRepairCore(await inflated(base64))
}
