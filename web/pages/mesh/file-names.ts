/** Names of files that are taken away of a mesh. */

const LONGEST = 100
/** Endings of compressed files stand behind their format's. */
const ENDINGS = /(?:\.[a-z][a-z0-9]{0,6})?(?:\.(?:gz|xz|zst|bz2))?$/i

/** The mesh's name without its ending, as a file on any system may be called. */
export function fileStem(name: string): string {
  const plain = name
    .replace(/^.*[\\/]/, '')
    .replace(ENDINGS, '')
    .replace(/[\p{C}\u2028\u2029<>:"|?*]/gu, '')
    .trim()
    .replace(/\s+/g, '-')
    .replace(/^[.-]+/, '')
  return plain === '' ? 'mesh' : [...plain].slice(0, LONGEST).join('')
}

/** "812 bytes", "1.2 MB". */
export function sizeWords(bytes: number): string {
  if (bytes < 1000) return `${bytes} bytes`
  const power = Math.min(3, Math.floor(Math.log10(bytes) / 3))
  return `${(bytes / 1000 ** power).toPrecision(3).replace(/\.?0+$/, '')} ${['', 'kB', 'MB', 'GB'][power]}`
}
