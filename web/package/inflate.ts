/** Bytes that are inside one file: base64 of what tools/package.mjs has deflated. */
export function inflated(base64: string): Promise<Uint8Array<ArrayBuffer>> {
  return inflate(Uint8Array.from(atob(base64), character => character.charCodeAt(0)))
}

/** `Response` would bring a network client along in Node, with wasm of its own. */
async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader()
  const chunks: Uint8Array<ArrayBuffer>[] = []
  for (let part = await reader.read(); !part.done; part = await reader.read()) chunks.push(part.value)
  return new Uint8Array(await new Blob(chunks).arrayBuffer())
}
