/** The worker that reads is a file beside the script, which would be half as large again with it inside, and is loaded when it is needed. */
import type { StartedWorker } from '../input/read-input'

const NAME = 'hexlens.mesh-worker.js'

/** Of a module its own address; of a plain script that of the tag, which only says so while it runs first. */
const script = globalThis.document?.currentScript
const here: string | undefined = script && 'src' in script ? script.src : import.meta.url

let findAddress = async (): Promise<string | URL> => new URL(NAME, here ?? document.baseURI)

/** For pages where the file lies elsewhere, as bundlers may have it: its address, or where to ask for that. */
export function setMeshWorker(address: string | URL | (() => Promise<string | URL>)): void {
  findAddress = typeof address === 'function' ? address : async () => address
}

export async function startMeshWorker(): Promise<StartedWorker> {
  return { worker: await startedWorker(), blocked: BLOCKED }
}

async function startedWorker(): Promise<Worker> {
  const address = new URL(await findAddress(), document.baseURI)
  if (address.origin === location.origin && address.protocol !== 'file:') return new Worker(address)
  // A worker's first script must be of the page's own origin; those that it asks for need not.
  const start = new Blob([`importScripts(${JSON.stringify(address.href)})`], { type: 'text/javascript' })
  return new Worker(URL.createObjectURL(start))
}

const BLOCKED = `${NAME} was not loaded from beside the script, or a policy of the page forbids it`
