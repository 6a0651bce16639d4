/** Reads what was pasted or dropped: text in any known format, or a picture that carries its element. */
import { type ImportResult, MOST_CHARACTERS, readElements, tooLarge } from '../../model/import/import'
import { decodePermalink } from '../../model/permalink'
import { isPng, PNG_KEYWORD, textOf } from '../../model/png-text'
import { startReadingWorker } from './start-reading-worker'

/** Characters that are read in a few milliseconds; more of them are read beside the page, which goes on. */
const AT_ONCE = 200_000

/** Ends early, without an answer, when the signal says so. */
export async function readOffer(content: string | File, signal: AbortSignal): Promise<ImportResult> {
  if (typeof content === 'string') return readText(content, signal)
  if (content.size > MOST_CHARACTERS) return { ok: false, message: tooLarge(content.size) }
  try {
    const bytes = new Uint8Array(await content.arrayBuffer())
    return isPng(bytes) ? readPng(bytes) : readText(decoded(bytes), signal)
  } catch (error) {
    if (!(error instanceof DOMException)) throw error
    return { ok: false, message: `The file could not be opened (${error.message}).` }
  }
}

function readPng(bytes: Uint8Array): ImportResult {
  const fragment = textOf(bytes, PNG_KEYWORD)
  if (fragment === null) {
    return { ok: false, message: 'This PNG has no element in it; those that are taken away from here have.' }
  }
  const link = decodePermalink(fragment)
  if (!link.ok) return { ok: false, message: link.error.message }
  return {
    ok: true,
    format: 'a picture from here',
    reading: { elements: [{ name: 'the picture’s element', vertices: link.value }], count: 1 },
  }
}

/** UTF-8, or UTF-16 with its mark, as some shells redirect output. */
function decoded(bytes: Uint8Array): string {
  const encoding = bytes[0] === 0xff && bytes[1] === 0xfe ? 'utf-16le' : 'utf-8'
  return new TextDecoder(encoding).decode(bytes)
}

function readText(text: string, signal: AbortSignal): ImportResult | Promise<ImportResult> {
  return text.length <= AT_ONCE || text.length > MOST_CHARACTERS ? readElements(text) : readBeside(text, signal)
}

function readBeside(text: string, signal: AbortSignal): Promise<ImportResult> {
  return new Promise(resolve => {
    const worker = startReadingWorker()
    if (worker === null) {
      resolve(readElements(text))
      return
    }
    signal.addEventListener('abort', () => worker.terminate())
    worker.addEventListener('message', ({ data }: MessageEvent<ImportResult>) => {
      worker.terminate()
      resolve(data)
    })
    worker.addEventListener('error', () => {
      worker.terminate()
      // Where a page's policy allows no worker, a pause is better than nothing.
      resolve(readElements(text))
    })
    worker.postMessage(text)
  })
}
