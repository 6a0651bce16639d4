// The files of the published package, but for the page: each one file, for browsers without a bundler as for bundlers.

import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { basename, dirname, join, resolve } from 'node:path'
import { promisify } from 'node:util'
import { leanReaders } from './lean-readers.mjs'
import { leanText } from './lean-text.mjs'
import { classFlags, leanThree } from './lean-three.mjs'
import { must, root, tsc } from './run.mjs'
import { withoutUnread } from './unread-members.mjs'

const source = path => join(root, 'web', path)

const BANNER = '/*! Hexlens, MIT; with three.js, MIT, and lit-html, BSD-3-Clause: licences.txt */'
const HDF5_BANNER = '/*! Hexlens, MIT; with h5wasm, NIST, and HDF5, BSD-3-Clause: licences.txt */'

const WASM = /^virtual:(.*\.wasm)\.deflated$/
const BATCH_WORKER = 'virtual:hexlens.batch-worker'

const insideOneFile = {
  name: 'hexlens-inside-one-file',
  enforce: 'pre',
  resolveId(id, importer) {
    if (importer && /\/hexlens[-.]twin\.js$/.test(id)) return { id: './hexlens.twin.js', external: true }
    if (/^(virtual:hexlens\.hdf5|\.\/hexlens\.hdf5\.js)$/.test(id)) return { id: './hexlens.hdf5.js', external: true }
    if (WASM.test(id) || id === BATCH_WORKER) return id
    return null
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

const ours = path => join(root, 'web', 'package', path)

/** The worker has no module format: a page starts it as it likes, Node as text. */
const batchWorker = { file: 'hexlens.batch-worker.js', format: 'iife', entry: source('core/batch/worker.ts') }

/**
 * The worker has no module format. A page may start a worker from its own origin alone: from
 * elsewhere, and from file://, it loads this as a script, which then gives itself to the page as a
 * function.
 */
const meshWorker = {
  file: 'hexlens.mesh-worker.js',
  format: 'iife',
  entry: ours('mesh-worker.ts'),
  around: ['(function work(){if(self.document)document.currentScript.work=work;else{', '}})()'],
}

const bundles = [
  { file: 'hexlens.es.js', entry: ours('hexlens.ts'), isWidget: true },
  { file: 'hexlens.iife.js', entry: ours('script.ts'), format: 'iife', isWidget: true },
  { file: 'hexlens.light.js', entry: ours('light.ts'), isWidget: true },
  { file: 'hexlens.hex-mesh.js', entry: ours('hex-mesh.ts'), isWidget: true },
  { file: 'hexlens.three.js', entry: ours('hexlens.ts'), external: /^three(\/|$)/ },
  { file: 'hexlens.core.js', entry: ours('core.ts') },
  { file: 'hexlens.batch.js', entry: ours('batch.ts') },
  batchWorker,
  { file: 'hexlens.mesh.js', entry: ours('mesh.ts') },
  meshWorker,
  { file: 'hexlens.hdf5.js', format: 'iife', entry: ours('hdf5.ts'), banner: HDF5_BANNER },
  { file: 'hexlens.anywidget.js', entry: ours('anywidget.ts'), isWidget: true },
  ...['de', 'zh'].map(tag => ({ file: `hexlens.lang.${tag}.js`, format: 'iife', entry: ours(`lang/${tag}.ts`) })),
  { file: 'hexlens.cli.js', entry: ours('cli.ts'), external: /^node:/ },
  { file: 'hexlens.twin.js', entry: join(root, 'build', 'hexlens-twin.js') },
]

/** Writes the package's scripts and types into a folder. */
export async function buildPackage(folder) {
  const outDir = resolve(root, folder)
  await buildScripts(outDir)
  await writeTypes(join(outDir, 'types'))
  writeFileSync(join(outDir, 'licences.txt'), licences())
}

/** Fills the folder that npm packs, but for the page: its README is for those who install it, its manifest without tools. */
export async function stagePackage(folder) {
  const {
    scripts: _,
    devDependencies: __,
    private: ___,
    ...manifest
  } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'))
  for (const path of ['LICENSE', ...manifest.files.filter(path => !path.startsWith('dist/'))])
    cpSync(join(root, path), join(folder, path))
  cpSync(ours('README.md'), join(folder, 'README.md'))
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify(manifest, null, 2)}\n`)
  await buildPackage(join(folder, 'dist'))
}

/** The scripts alone: all, or those of these names. */
export async function buildScripts(outDir, names = bundles.map(({ file }) => file)) {
  mkdirSync(outDir, { recursive: true })
  for (const bundle of bundles.filter(({ file }) => names.includes(file)))
    writeFileSync(join(outDir, bundle.file), await scriptOf(bundle))
}

/** Licences of all that the scripts hold: each wants its notice kept. */
function licences() {
  const parts = [
    ['Hexlens', 'LICENSE'],
    ['three.js', 'node_modules/three/LICENSE'],
    ['lit-html', 'node_modules/lit-html/LICENSE'],
    ['h5wasm, with HDF5, for files in HDF5', 'node_modules/h5wasm/LICENSE.txt'],
    ['uqr, for QR codes on paper', 'node_modules/uqr/LICENSE'],
    ['STIX Two Math, for the formulas of the lessons', 'web/pages/lessons/math-font/OFL.txt'],
  ]
  return parts.map(([name, path]) => `${name}\n\n${readFileSync(join(root, path), 'utf8').trim()}\n`).join('\n\n')
}

/**
 * The text of a bundle. In a build of one file, modules that pages load on demand, and all that
 * they import, become functions, which adds 2.4 kB. In chunks they do not, but chunks are not one
 * file: they are made first, and the file of them. gzip looks back 32 kB, so that wasm and
 * libraries do not come between modules of ours.
 */
async function scriptOf({
  entry,
  isWidget = false,
  format = 'es',
  external = [],
  around: [before, after] = ['', ''],
  banner = BANNER,
}) {
  const groups = [
    { name: 'wasm', test: /-inside\.ts$/ },
    { name: 'three', test: /node_modules\/three\// },
    { name: 'libraries', test: /node_modules/ },
    { name: 'ours' },
  ]
  const split = { codeSplitting: { groups }, minify: false }
  const plugins = [insideOneFile, leanThree, leanReaders, leanText]
  const chunks = await withLeanThree(await chunksOf({ entry, formats: ['es'] }, plugins, external, split))
  const whole = { codeSplitting: false, minify: true, postBanner: `${banner}\n${before}`, postFooter: after }
  const given = { entry: chunks[0].fileName, formats: [format], name: 'hexlens' }
  const [{ code }] = await chunksOf(given, [modulesOf(chunks), insideOneFile], external, whole)
  return isWidget ? smallest(code, format) : code
}

async function withLeanThree(chunks) {
  const isThree = ({ name }) => name === 'three'
  const others = chunks.filter(chunk => !isThree(chunk)).map(({ code }) => code)
  return Promise.all(
    chunks.map(async chunk => {
      const { fileName, code } = chunk
      return { fileName, code: isThree(chunk) ? await withoutUnread(code, others, classFlags()) : code }
    }),
  )
}

/** Terser takes 2.6 kB more away than rolldown's minifier, and seconds to do it. */
async function smallest(code, format) {
  const { minify } = await import('terser')
  const options = { module: format === 'es', ecma: 2022, compress: { passes: 2 }, format: { comments: /^!/ } }
  return (await minify(code, options)).code
}

async function chunksOf(lib, plugins, external, output) {
  const { build } = await import('vite')
  const [result] = await build({
    configFile: false,
    root,
    publicDir: false,
    logLevel: 'warn',
    plugins,
    // lit-html as it runs on a server, too
    resolve: { conditions: ['node'] },
    build: {
      target: 'es2022',
      // Browsers with light-dark(): a rewritten one follows no scheme but the one it is declared in.
      cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
      write: false,
      lib,
      rolldownOptions: {
        external,
        // three.js warns those who write against it; that is done before it is built.
        treeshake: { propertyReadSideEffects: false, manualPureFunctions: ['warn', 'warnOnce'] },
        output,
        // A plain script has no import.meta and does without.
        checks: { bundlerTimings: false, emptyImportMeta: false, ineffectiveDynamicImport: false },
      },
    },
  })
  return result.output
}

/** Chunks as the modules of another build. */
function modulesOf(chunks) {
  const codes = new Map(chunks.map(({ fileName, code }) => [fileName, code]))
  return {
    name: 'hexlens-chunks',
    enforce: 'pre',
    resolveId: id => (codes.has(basename(id)) ? basename(id) : null),
    load: id => codes.get(id),
  }
}

/**
 * Declarations of what the entries export and of what that names. Readers of a package ask for file
 * names in full; tsc leaves them as our sources, which a bundler reads, have them.
 */
export async function writeTypes(outDir) {
  rmSync(outDir, { recursive: true, force: true })
  const project = join(root, 'tsconfig.types.json')
  await must(process.execPath, [tsc, '-p', project, '--outDir', outDir], 'The types were not written.')
  const entries = [
    'hexlens',
    'light',
    'hex-mesh',
    'react',
    'preact',
    'vue',
    'svelte',
    'core',
    'batch',
    'mesh',
    'lang/de',
    'lang/zh',
  ]
  const named = new Set(entries.map(name => join(outDir, 'package', `${name}.d.ts`)))
  for (const path of named) {
    const text = readFileSync(path, 'utf8').replace(/(from |import |import\()'(\.[^']+)'/g, (_, before, name) => {
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
