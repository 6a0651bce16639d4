// The files of the published package, but for the page: each one file, for browsers without a bundler as for bundlers.

import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { promisify } from 'node:util'
import { leanThree } from './lean-three.mjs'
import { Failure, must, root, tsc } from './run.mjs'

const source = path => join(root, 'web', path)

const BANNER = '/*! Hexlens, MIT; with three.js, MIT, and lit-html, BSD-3-Clause: licences.txt */'

const WASM = /^virtual:(.*\.wasm)\.deflated$/
const BATCH_WORKER = 'virtual:hexlens.batch-worker'
const TWIN = './hexlens.twin.js'

const insideOneFile = {
  name: 'hexlens-inside-one-file',
  enforce: 'pre',
  resolveId(id) {
    if (id.endsWith('/hexlens-twin.js')) return { id: TWIN, external: true }
    if (WASM.test(id) || id === BATCH_WORKER) return id
    return null
  },
  /** Modules that the page loads on demand are imported: they share one scope, which is smaller. */
  transform(code, id) {
    if (!id.startsWith(source('')) || !code.includes('import(')) return null
    const hoisted = []
    const mended = code.replace(/import\((['"])(\.[^'"]+)\1\)/g, (dynamic, quote, name) => {
      if (name.endsWith('hexlens-twin.js')) return dynamic
      hoisted.push(`import * as inside${hoisted.length} from ${quote}${name}${quote}`)
      return `Promise.resolve(inside${hoisted.length - 1})`
    })
    return { code: `${hoisted.join('\n')}\n${mended}`, map: null }
  },
  /** Deflated before it is text: text of other bytes hardly compresses when the file is sent. */
  async load(id) {
    if (id === BATCH_WORKER) return `export default ${JSON.stringify(await scriptOf(batchWorker))}`
    const [, name] = WASM.exec(id) ?? []
    if (name === undefined) return null
    return `export default '${await deflatedText(name)}'`
  },
}

const deflatedTexts = new Map()

/** Several scripts hold the same wasm, and deflating it takes seconds. */
function deflatedText(name) {
  const text = deflatedTexts.get(name) ?? deflate(name)
  deflatedTexts.set(name, text)
  return text
}

async function deflate(name) {
  const { default: zopfli } = await import('@gfx/zopfli') // not before it is installed
  const deflated = await promisify(zopfli.zlib)(readFileSync(join(root, 'build', name)), { numiterations: 15 })
  return Buffer.from(deflated).toString('base64')
}

/** lit-html as it runs on a server too, and without the global in which it notes its version: a guest leaves nothing behind. */
const litHtml = join(root, 'node_modules', 'lit-html', 'node', 'lit-html.js')
const modestLit = {
  name: 'hexlens-modest-lit',
  enforce: 'pre',
  resolveId: id => (id === 'lit-html' ? litHtml : null),
  transform(code, id) {
    if (id !== litHtml) return null
    const mended = code.replace(/,\(\w+\.litHtmlVersions\?\?=\[\]\)\.push\("[^"]*"\)/, '')
    if (mended === code) throw new Failure('This lit-html notes its version in another way: mend tools/package.mjs.')
    return { code: mended, map: null }
  },
}

/** The name of three.js in the import maps of pages without a bundler. */
const threeOutside = {
  name: 'hexlens-three-outside',
  enforce: 'pre',
  resolveId(id) {
    if (id === 'three') return { id, external: true }
    const addon = /^three\/examples\/jsm\/(.*)$/.exec(id)
    return addon ? { id: `three/addons/${addon[1]}`, external: true } : null
  },
}

const nodeOutside = {
  name: 'hexlens-node-outside',
  enforce: 'pre',
  resolveId: id => (id.startsWith('node:') ? { id, external: true } : null),
}

const ours = path => join(root, 'web', 'package', path)

/** The worker has no module format: a page starts it as it likes, Node as text. */
const batchWorker = {
  file: 'hexlens.batch-worker.js',
  format: 'iife',
  entry: source('core/batch/worker.ts'),
  plugins: [],
}

/**
 * The worker has no module format. A page may start a worker from its own origin alone: from
 * elsewhere, and from file://, it loads this as a script, which then gives itself to the page as a
 * function.
 */
const meshWorker = {
  file: 'hexlens.mesh-worker.js',
  format: 'iife',
  entry: ours('mesh-worker.ts'),
  plugins: [insideOneFile],
  around: ['(function work(){if(self.document)document.currentScript.work=work;else{', '}})()'],
}

const bundles = [
  { file: 'hexlens.es.js', format: 'es', entry: ours('hexlens.ts'), plugins: [insideOneFile, modestLit, leanThree] },
  { file: 'hexlens.iife.js', format: 'iife', entry: ours('script.ts'), plugins: [insideOneFile, modestLit, leanThree] },
  {
    file: 'hexlens.three.js',
    format: 'es',
    entry: ours('hexlens.ts'),
    plugins: [insideOneFile, modestLit, threeOutside],
  },
  { file: 'hexlens.core.js', format: 'es', entry: ours('core.ts'), plugins: [insideOneFile] },
  { file: 'hexlens.batch.js', format: 'es', entry: ours('batch.ts'), plugins: [insideOneFile] },
  batchWorker,
  { file: 'hexlens.mesh.js', format: 'es', entry: ours('mesh.ts'), plugins: [insideOneFile] },
  meshWorker,
  {
    file: 'hexlens.anywidget.js',
    format: 'es',
    entry: ours('anywidget.ts'),
    plugins: [insideOneFile, modestLit, leanThree],
  },
  { file: 'hexlens.cli.js', format: 'es', entry: ours('cli.ts'), plugins: [insideOneFile, nodeOutside] },
  { file: 'hexlens.twin.js', format: 'es', entry: join(root, 'build', 'hexlens-twin.js'), plugins: [] },
]

/** Writes the package's scripts and types into a folder. */
export async function buildPackage(folder) {
  const outDir = resolve(root, folder)
  await buildScripts(outDir)
  await writeTypes(join(outDir, 'types'))
  writeFileSync(join(outDir, 'licences.txt'), licences())
}

/** The scripts alone. */
export async function buildScripts(outDir) {
  for (const bundle of bundles) await bundleOneFile(bundle, outDir)
}

/** Licences of all that the scripts hold: each wants its notice kept. */
function licences() {
  const parts = [
    ['Hexlens', 'LICENSE'],
    ['three.js', 'node_modules/three/LICENSE'],
    ['lit-html', 'node_modules/lit-html/LICENSE'],
    ['STIX Two Math, for the formulas of the lessons', 'web/pages/lessons/math-font/OFL.txt'],
  ]
  return parts.map(([name, path]) => `${name}\n\n${readFileSync(join(root, path), 'utf8').trim()}\n`).join('\n\n')
}

async function bundleOneFile(bundle, outDir) {
  const { build } = await import('vite')
  await build(configOf(bundle, { outDir, emptyOutDir: false }))
}

/** The text of a bundle. */
async function scriptOf(bundle) {
  const { build } = await import('vite')
  const [{ output }] = await build(configOf(bundle, { write: false }))
  return output[0].code
}

function configOf({ file, format, entry, plugins, around: [before, after] = ['', ''] }, where) {
  return {
    configFile: false,
    root,
    publicDir: false,
    logLevel: 'warn',
    plugins,
    build: {
      target: 'es2022',
      ...where,
      lib: { entry, formats: [format], name: 'hexlens', fileName: () => file },
      rolldownOptions: {
        output: { codeSplitting: false, minify: true, postBanner: `${BANNER}\n${before}`, postFooter: after },
        // A plain script has no import.meta and does without.
        checks: { bundlerTimings: false, emptyImportMeta: false },
      },
    },
  }
}

/** Declarations of what the entries export and of what that names, with file names in full: readers of a package ask for them. */
async function writeTypes(outDir) {
  rmSync(outDir, { recursive: true, force: true })
  const project = join(root, 'tsconfig.types.json')
  await must(process.execPath, [tsc, '-p', project, '--outDir', outDir], 'The types were not written.')
  const named = new Set(
    ['package/hexlens', 'package/core', 'package/batch', 'package/mesh'].map(name => join(outDir, `${name}.d.ts`)),
  )
  for (const path of named) {
    const text = readFileSync(path, 'utf8').replace(/(from |import\()'(\.[^']+)'/g, (_, before, name) => {
      named.add(join(dirname(path), `${name}.d.ts`))
      return `${before}'${name}.js'`
    })
    writeFileSync(path, text)
  }
  for (const { name, parentPath } of readdirSync(outDir, { recursive: true, withFileTypes: true })) {
    const path = join(parentPath, name)
    if (path.endsWith('.d.ts') && !named.has(path)) rmSync(path)
  }
}
