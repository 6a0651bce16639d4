/** The file at an address, by the host's rules: its origin, its policy, its server's headers. */
import { say } from '../words/say'
import { MeshProblem } from './problem'

/** Nobody who opens a page has asked for more bytes than this. A file of any size can be opened by `open()`. */
const MOST_BYTES = 512 * 2 ** 20

export interface Fetching {
  readonly signal: AbortSignal
  readonly onProgress: (fraction: number) => void
  /** Bytes. */
  readonly most?: number
}

/** Rejects with MeshProblem; with the signal's reason if that aborts. The bytes stay with the browser: none is copied here. */
export async function fetchedFile(source: string, { signal, onProgress, most = MOST_BYTES }: Fetching): Promise<File> {
  const address = addressOf(source)
  const name = nameOf(address)
  const response = await fetch(address, { signal }).catch(() => {
    signal.throwIfAborted()
    throw new MeshProblem('not-fetched', () =>
      say(
        '{name} could not be fetched: there is no such server, it does not let this page read the file (CORS), or a policy of the page forbids it.',
        { name },
      ),
    )
  })
  if (!response.ok)
    throw new MeshProblem('not-fetched', () =>
      say('{name} could not be fetched: the server answers {status}.', {
        name,
        status: `${response.status} ${response.statusText}`.trim(),
      }),
    )
  const blob = await bytesOf(response, name, most, onProgress).catch(reason => {
    signal.throwIfAborted()
    if (reason instanceof MeshProblem) throw reason
    throw new MeshProblem('not-fetched', () =>
      say('{name} could not be fetched: the connection or the memory ended before the file.', { name }),
    )
  })
  return new File([blob], name)
}

function addressOf(source: string): URL {
  try {
    return new URL(source, document.baseURI)
  } catch {
    throw new MeshProblem('not-fetched', () =>
      say('{name} could not be fetched: it is not an address.', { name: source }),
    )
  }
}

/** Readers know formats by the ends of names. */
function nameOf({ pathname, href }: URL): string {
  const last = pathname.slice(pathname.lastIndexOf('/') + 1)
  try {
    return decodeURIComponent(last) || href
  } catch {
    return last
  }
}

async function bytesOf(
  response: Response,
  name: string,
  most: number,
  onProgress: (fraction: number) => void,
): Promise<Blob> {
  // Of a compressed response it is the length on the way: the sum of what arrives may be greater.
  const length = Number(response.headers.get('content-length') ?? 0)
  const refuseAbove = (bytes: number) => {
    if (bytes > most)
      throw new MeshProblem('too-large', () =>
        say('{name} is larger than {most} MB, the most that is fetched with a page.', {
          name,
          most: most / 2 ** 20,
        }),
      )
  }
  if (length > most) await response.body?.cancel()
  refuseAbove(length)
  if (!response.body) return response.blob()
  let sum = 0
  const counting = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
    transform(chunk, controller) {
      sum += chunk.length
      refuseAbove(sum)
      onProgress(length > 0 ? Math.min(sum / length, 1) : 0)
      controller.enqueue(chunk)
    },
  })
  return new Response(response.body.pipeThrough(counting)).blob()
}
