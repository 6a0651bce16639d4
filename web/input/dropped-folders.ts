/** Folders that are dropped: all files in them, whatever their depth. */
import type { PastedInput } from './pasted-input'

/** The input of a drop with the files of its folders in their place. Hidden files, which systems leave everywhere, are none. */
export function unfolded(event: DragEvent, input: PastedInput): PastedInput | Promise<PastedInput> {
  // Entries are there as long as the event.
  const entries = Array.from(event.dataTransfer?.items ?? [], item => item.webkitGetAsEntry()).filter(
    entry => entry !== null,
  )
  if (!('files' in input) || !entries.some(({ isDirectory }) => isDirectory)) return input
  return Promise.all(entries.map(filesIn)).then(files => ({ files: files.flat() }))
}

async function filesIn(entry: FileSystemEntry): Promise<File[]> {
  if (entry.name.startsWith('.')) return []
  if (entry.isFile) return [await new Promise<File>((...both) => (entry as FileSystemFileEntry).file(...both))]
  const reader = (entry as FileSystemDirectoryEntry).createReader()
  const files: File[] = []
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((...both) => reader.readEntries(...both))
    if (some.length === 0) return files
    for (const inner of some) files.push(...(await filesIn(inner)))
  }
}
