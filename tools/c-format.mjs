// clang-format over all C sources and tests, in the style of .clang-format.

import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { root } from './run.mjs'

const FOLDERS = ['wasm', 'tests/core', 'docs/c']

/** The C files that are not formatted, relative to the root; with `write` they are when this returns. */
export async function unformattedC({ write = false } = {}) {
  const { format } = await import('@wasm-fmt/clang-format')
  const style = readFileSync(join(root, '.clang-format'), 'utf8')
  return sources().filter(name => {
    const text = readFileSync(join(root, name), 'utf8')
    const formatted = format(text, name, style)
    if (write && formatted !== text) writeFileSync(join(root, name), formatted)
    return formatted !== text
  })
}

function sources() {
  return FOLDERS.filter(folder => existsSync(join(root, folder))).flatMap(folder =>
    readdirSync(join(root, folder), { recursive: true })
      .filter(name => /\.([ch]|cpp)$/.test(name))
      .map(name => join(folder, name)),
  )
}
