/** The core for batches as files beside the page's. */
import vectorUrl from '../../../build/hexlens-batch.wasm?url'
import scalarUrl from '../../../build/hexlens-scalar.wasm?url'
import { compiledOf } from './start'

export function batchFiles(): Promise<WebAssembly.Module> {
  return compiledOf({ vectors: () => bytesAt(vectorUrl), scalar: () => bytesAt(scalarUrl) })
}

async function bytesAt(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url)
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
  return response.arrayBuffer()
}
