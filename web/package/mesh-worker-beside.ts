/** The worker that reads is a file beside the script, which would be half as large again with it inside, and is loaded when it is needed. */
import { pagePort } from '../core/ports'
import { scriptAddress } from '../core/script-address'
import type { ReadingWorker } from '../input/input-reader'

const NAME = 'hexlens.mesh-worker.js'
const BLOCKED = `${NAME} was not loaded from beside the script, or a policy of the page forbids it.`

/** This module's address, or the script's, which its tag tells only while it first runs. */
const script = globalThis.document?.currentScript
const here: string | undefined = script && 'src' in script ? script.src : import.meta.url

let findAddress = async (): Promise<string | URL> => new URL(NAME, here ?? document.baseURI)

/** Sets the file's address, or a function that knows it, if bundlers have moved the file. */
export function setMeshWorker(address: string | URL | (() => Promise<string | URL>)): void {
  findAddress = typeof address === 'function' ? address : async () => address
}

export const readingWorkerBeside: ReadingWorker = async () => {
  const address = new URL(await findAddress(), document.baseURI)
  const isOwn = address.origin === location.origin && address.protocol !== 'file:'
  const script = isOwn ? address : await addressOfCopy(address.href)
  return () => pagePort(new Worker(scriptAddress(script)), BLOCKED)
}

type HandedOver = HTMLScriptElement & { readonly work?: () => void }

const copies = new Map<string, Promise<string>>()

/** A worker cannot be of another origin; loaded as a script, the file gives itself as a function. */
function addressOfCopy(address: string): Promise<string> {
  const copy = copies.get(address) ?? copied(address)
  copies.set(address, copy)
  copy.catch(() => copies.delete(address))
  return copy
}

async function copied(address: string): Promise<string> {
  const script: HandedOver = document.createElement('script')
  await new Promise((resolve, reject) => {
    script.onload = resolve
    script.onerror = () => reject(new Error(BLOCKED))
    script.src = scriptAddress(address)
    document.head.append(script)
  }).finally(() => script.remove())
  return URL.createObjectURL(
    new Blob([`hexlensScript=${JSON.stringify(address)};(${script.work})()`], { type: 'text/javascript' }),
  )
}
