/** Folders that are dropped: all files in them, whatever their depth. */
import type { PastedInput } from './pasted-input'

/** The input of a drop with the files of its folders in their place. Hidden files, which systems leave everywhere, are none. */
export function unfolded(event: DragEvent, input: PastedInput): PastedInput | Promise<PastedInput> {
  // Entries are there as long as the event.
  const entries = Array.from(event.dataTransfer?.items ?? [], item => item.webkitGetAsEntry()).filter(
    entry => entry !== null,
  )
  if (!('files' in input) || !entries.some(({ isDirectory }) => isDirectory)) return input
  return Promise.all(entries.map(filesIn)).then(found => withPaths(found.flat()))
}

/** The files of a folder that a reader chose to open. */
export function ofFolder(files: readonly File[]): PastedInput {
  const found = files.map(file => ({ file, path: file.webkitRelativePath || file.name }))
  return withPaths(found.filter(({ path }) => !/(?:^|\/)\./.test(path)))
}

interface FoundFile {
  readonly file: File
  readonly path: string
}

function withPaths(found: readonly FoundFile[]): PastedInput {
  return { files: found.map(({ file }) => file), paths: found.map(({ path }) => path) }
}

async function filesIn(entry: FileSystemEntry): Promise<FoundFile[]> {
  if (entry.name.startsWith('.')) return []
  if (entry.isFile) {
    const file = await new Promise<File>((...both) => (entry as FileSystemFileEntry).file(...both))
    return [{ file, path: entry.fullPath.replace(/^\//, '') }]
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader()
  const files: FoundFile[] = []
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((...both) => reader.readEntries(...both))
    if (some.length === 0) return files
    for (const inner of some) files.push(...(await filesIn(inner)))
  }
}
