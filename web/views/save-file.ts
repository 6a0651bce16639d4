/** Hands a file to the reader, as a download. */

/** An address of a file is given back once the browser has surely begun to save it. */
const SAVED_MS = 10_000

export function saveFile(name: string, content: BlobPart, mediaType: string): void {
  const address = URL.createObjectURL(new Blob([content], { type: mediaType }))
  const link = document.createElement('a')
  link.href = address
  link.download = name
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), SAVED_MS)
}
