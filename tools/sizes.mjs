// Sizes against their budgets: the page until it is live, the one-file widget and the lighter file, a mesh, batches, reading, repair.

import { readFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { buildPage } from './build.mjs'
import { buildScripts } from './package.mjs'
import { root } from './run.mjs'

/** Bytes after gzip. */
const BUDGETS = {
  wasm: 24_000,
  repairWasm: 36_000,
  firstLoad: 230_000,
  widget: 190_000,
  light: 130_000,
  hexMesh: 60_000,
  batch: 104_000,
  mesh: 125_000,
  meshWorker: 274_000,
  hdf5: 1_100_000,
}

/** Scripts and their budgets. */
const SCRIPTS = {
  'hexlens.es.js': BUDGETS.widget,
  'hexlens.iife.js': BUDGETS.widget,
  'hexlens.light.js': BUDGETS.light,
  'hexlens.hex-mesh.js': BUDGETS.hexMesh,
  'hexlens.batch.js': BUDGETS.batch,
  'hexlens.mesh.js': BUDGETS.mesh,
  'hexlens.mesh-worker.js': BUDGETS.meshWorker,
  'hexlens.hdf5.js': BUDGETS.hdf5,
}

/** Builds page and scripts and resolves to { table, exceeded }: lines to print, and whether a budget is exceeded. */
export async function checkSizes() {
  const folder = 'dist/check'
  const { output } = await buildPage(folder)
  await buildScripts(join(root, folder))
  const sizeOf = name => gzipSync(readFileSync(join(root, folder, name)), { level: 9 }).length
  const files = firstLoad(output).map(name => ({ name, size: sizeOf(name) }))
  const sum = list => list.reduce((total, { size }) => total + size, 0)
  const checks = [
    { what: 'wasm', size: sum(files.filter(({ name }) => name.endsWith('.wasm'))), budget: BUDGETS.wasm },
    {
      what: 'hexlens-repair.wasm',
      size: gzipSync(readFileSync(join(root, 'build/hexlens-repair.wasm')), { level: 9 }).length,
      budget: BUDGETS.repairWasm,
    },
    { what: 'first load', size: sum(files), budget: BUDGETS.firstLoad },
    ...Object.entries(SCRIPTS).map(([name, budget]) => ({ what: name, size: sizeOf(name), budget })),
  ]
  return {
    table: [
      ...files.map(({ name, size }) => row(name, size)),
      ...checks.map(({ what, size, budget }) => `${row(what, size)} of ${(budget / 1000).toFixed(1)} kB`),
    ],
    exceeded: checks.some(({ size, budget }) => size === 0 || size > budget),
  }
}

function row(name, size) {
  return `${name.padEnd(44)} ${(size / 1000).toFixed(1).padStart(6)} kB gzip`
}

/** The page, its entry with all that it imports at once, and the styles, wasm and worker files these name. */
function firstLoad(output) {
  const byName = new Map(output.map(file => [file.fileName, file]))
  const loaded = new Set(['index.html'])
  const queue = output
    .filter(file => file.isEntry && file.facadeModuleId.endsWith('index.html'))
    .map(file => file.fileName)
  for (const name of queue) {
    if (loaded.has(name)) continue
    loaded.add(name)
    const file = byName.get(name)
    if (file?.type !== 'chunk') continue
    queue.push(...file.imports, ...(file.viteMetadata?.importedCss ?? []))
    for (const other of output) {
      if (
        other.type === 'asset' &&
        /\.(wasm|js)$/.test(other.fileName) &&
        file.code.includes(basename(other.fileName))
      ) {
        queue.push(other.fileName)
      }
    }
  }
  return [...loaded]
}
