/**
 * A series in the letters of a link: JSON, deflated, in base64url. Texts shrink to about a third, so
 * that a few challenges fit into a QR code; and no mail or chat program cuts a link off at such
 * letters, as they do at brackets and quotation marks.
 */
import type { Result } from '../../model/result'
import { readSeries, type Series, type SeriesDocument } from './series'

/** The most characters of JSON that are read: more than MOST_CHALLENGES with their elements need. */
export const MOST_JSON = 200_000

export async function encodeSeries(document: SeriesDocument): Promise<string> {
  const text = new TextEncoder().encode(JSON.stringify(document))
  const deflated = await new Response(through(text, new CompressionStream('deflate-raw'))).arrayBuffer()
  const binary = Array.from(new Uint8Array(deflated), byte => String.fromCharCode(byte)).join('')
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

export async function decodeSeries(code: string): Promise<Result<Series, string>> {
  const json = await inflated(code).catch(() => null)
  if (json === null) return broken('what it holds is cut off or changed')
  if (json.length > MOST_JSON) return broken(`it holds more than ${MOST_JSON} characters`)
  try {
    return readSeries(JSON.parse(json))
  } catch {
    return broken('what it holds is no JSON')
  }
}

function broken(why: string): Result<never, string> {
  return { ok: false, error: `The link is broken: ${why}.` }
}

/** Little more than MOST_JSON characters, however much there is. Rejects what is not such a text. */
async function inflated(code: string): Promise<string> {
  if (!/^[\w-]+$/.test(code)) throw new TypeError('These are not the letters of base64url.')
  const binary = atob(code.replaceAll('-', '+').replaceAll('_', '/'))
  const bytes = Uint8Array.from(binary, letter => letter.charCodeAt(0))
  const pieces = through(bytes, new DecompressionStream('deflate-raw')).getReader()
  const decoder = new TextDecoder('utf-8', { fatal: true })
  let text = ''
  while (text.length <= MOST_JSON) {
    const { done, value } = await pieces.read()
    if (done) return text + decoder.decode()
    text += decoder.decode(value, { stream: true })
  }
  await pieces.cancel()
  return text
}

function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): ReadableStream<Uint8Array> {
  return new Blob([bytes]).stream().pipeThrough(stream as TransformStream<Uint8Array, Uint8Array>)
}
