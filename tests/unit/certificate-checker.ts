/** Runs tests/certificates/check_certificates.py, which shares nothing with what it checks. */
import { spawnSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { certificateJson, certify } from '../../web/core/exact/certificate'
import type { Vertices } from '../../web/model/hexahedron'

const program = fileURLToPath(new URL('../certificates/check_certificates.py', import.meta.url))

export interface Checked {
  readonly status: number | null
  readonly output: string
  readonly errors: string
}

/** Runs the checker on the texts of one or two files. */
export function checked(...texts: string[]): Checked {
  const folder = mkdtempSync(join(tmpdir(), 'hexlens-'))
  try {
    const files = texts.map((_, i) => join(folder, `${i}.json`))
    for (const [i, file] of files.entries()) writeFileSync(file, texts[i] as string)
    const { error, status, stdout, stderr } = spawnSync('python3', ['-I', program, ...files], {
      encoding: 'utf8',
      maxBuffer: 2 ** 26,
    })
    if (error) throw new Error(`The certificates' checker needs python3 (3.9 or later) on PATH: ${error.message}`)
    return { status, output: stdout, errors: stderr }
  } finally {
    rmSync(folder, { recursive: true })
  }
}

/** A certificate as JSON.parse returns it, so that tests may change whatever they like. */
// biome-ignore lint/suspicious/noExplicitAny: tampering knows no types
export type Loose = any

export function certificateOf(name: string, vertices: Vertices): Loose {
  return JSON.parse(JSON.stringify(certificateJson(name, vertices, certify(vertices))))
}
