/** Files of a browser as the readers of web/mesh see them: read by slices, at once, which only workers can. */
import type { MeshFile } from '../mesh/source'

/** Workers alone have it, and the types of a page do not. */
declare class FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer
}

export function meshFileOf(file: File): MeshFile {
  const reader = new FileReaderSync()
  return {
    name: file.name,
    size: file.size,
    read: (from, to) => new Uint8Array(reader.readAsArrayBuffer(file.slice(from, to))),
  }
}
