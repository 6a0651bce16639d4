/** `hexlens/batch` as npm installs it: in Node, behind bundlers and without, and what is said where its workers may not run or fail. */
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { promisify } from 'node:util'
import type { Page } from '@playwright/test'
import * as esbuild from 'esbuild'
import { createServer, type InlineConfig, build as viteBuild } from 'vite'
import webpack from 'webpack'
import type { Report } from '../../web/core/report'
import { elsewhere, expect, root, test } from './elsewhere'

const dist = join(elsewhere, 'node_modules/hexlens/dist')

/** A user's file, which each host below runs. Its answer is JSON, as a page returns it. */
const ANSWER = `import { CLASSES, STATUSES, startClassifier } from 'hexlens/batch'

export async function answer(hexahedra) {
  const classifier = await startClassifier({ workers: 2 })
  const points = new Float64Array(hexahedra.flat())
  const cells = Uint32Array.from({ length: 8 * hexahedra.length }, (_, i) => i)
  const plain = ({ value: { valid, minima, validCount } }) => ({
    valid: [...valid],
    values: [...minima.values],
    minimizers: [...minima.minimizers],
    validCount,
  })
  const classified = plain(await classifier.classify(points, cells, { minima: true }))
  const streamed = []
  const chunks = hexahedra.map(hexahedron => ({ points: new Float64Array(hexahedron) }))
  for await (const result of classifier.stream(chunks, { minima: true, handOver: true })) streamed.push(plain(result))
  points[24] = Number.NaN
  const { value } = await classifier.classify(points, null, { classes: true, statuses: true })
  const { validCount, unansweredCount, firstUnanswered, minima } = value
  const status = STATUSES[value.statuses[1]]
  const classes = [...value.classes].map(place => CLASSES[place] ?? null)
  const unanswered = { validCount, unansweredCount, firstUnanswered, minima, status, classes }
  const refusal = await classifier.classify(points.subarray(1), null)
  classifier.close()
  return { classified, streamed, handedOver: chunks.every(chunk => chunk.points.length === 0), unanswered, refusal }
}
`

interface Fixture {
  readonly hexahedra: number[][]
  readonly expected: unknown
}

/** Hard cases with exact verdicts, and what the core in the package says of their minima. */
async function fixture(): Promise<Fixture> {
  const { loadCore } = await import(pathToFileURL(join(dist, 'hexlens.core.js')).href)
  const core = await loadCore()
  const vectors = JSON.parse(readFileSync(join(root, 'tests/vectors/public_cases.json'), 'utf8'))
  const cases: { vertices: number[]; valid: boolean; report: Report }[] = vectors
    .map((one: { vertices: number[][]; answer: { valid: boolean } }) => {
      const vertices = one.vertices.flat()
      return { vertices, valid: one.answer.valid, report: core.analyze(vertices).value }
    })
    .filter(({ report }: { report: Report }) => report.exponent === 0)
  expect(cases.length).toBeGreaterThan(50)
  const each = cases.map(({ valid, report: { boundaryMinimum, minimizer } }) => ({
    valid: [Number(valid)],
    values: [boundaryMinimum],
    minimizers: minimizer.point,
    validCount: Number(valid),
  }))
  const classified = {
    valid: each.flatMap(({ valid }) => valid),
    values: each.flatMap(({ values }) => values),
    minimizers: each.flatMap(({ minimizers }) => minimizers),
    validCount: each.reduce((sum, { validCount }) => sum + validCount, 0),
  }
  const unanswered = {
    validCount: classified.validCount - Number(cases[1]?.valid),
    unansweredCount: 1,
    firstUnanswered: 1,
    minima: null,
    status: 'not-finite',
    classes: cases.map(({ report }, cell) => (cell === 1 ? null : report.class)),
  }
  const cell = cases.length - 1
  const message = `Cell ${cell} is incomplete: 24 coordinates make one.`
  const refusal = { ok: false, error: { code: 'incomplete', cell, message } }
  const expected = { classified, streamed: each, handedOver: true, unanswered, refusal }
  return { hexahedra: cases.map(({ vertices }) => vertices), expected: JSON.parse(JSON.stringify(expected)) }
}

/** A new folder with that file, an entry that makes it global, and a page that loads a script. */
function site(name: string, script: string, head = ''): string {
  const folder = join(elsewhere, name)
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, 'answer.js'), ANSWER)
  writeFileSync(join(folder, 'entry.js'), "import { answer } from './answer.js'\nglobalThis.answer = answer\n")
  writeFileSync(join(folder, 'index.html'), html(script, head))
  return folder
}

const html = (script: string, head = '') =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">${head}</head><body>${script}</body></html>`

const IMPORT_MAP = `<script type="importmap">{ "imports": { "hexlens/batch": "../node_modules/hexlens/dist/hexlens.batch.js" } }</script>`

async function expectAnswer(page: Page, address: string): Promise<void> {
  const complaints: string[] = []
  page.on('pageerror', error => complaints.push(error.message))
  page.on('console', message => void (message.type() === 'error' && complaints.push(message.text())))
  const { hexahedra, expected } = await fixture()
  await page.goto(address)
  await page.waitForFunction(() => 'answer' in globalThis)
  const answered = await page.evaluate(
    async given => (globalThis as unknown as { answer(given: number[][]): unknown }).answer(given),
    hexahedra,
  )
  expect(JSON.parse(JSON.stringify(answered))).toEqual(expected)
  expect(complaints).toEqual([])
}

test('from a plain module script', async ({ page }) => {
  site('plain', '<script type="module" src="entry.js"></script>', IMPORT_MAP)
  await expectAnswer(page, 'plain/')
})

test('behind Vite, built and in development', async ({ page }) => {
  const folder = site('vite', '<script type="module" src="/entry.js"></script>')
  const config = { root: folder, configFile: false, logLevel: 'error', base: './' } satisfies InlineConfig
  await viteBuild({ ...config, build: { outDir: 'site' } })
  await expectAnswer(page, 'vite/site/')
  const server = await createServer({ ...config, cacheDir: join(folder, 'cache'), server: { host: '127.0.0.1' } })
  try {
    await server.listen()
    await expectAnswer(page, server.resolvedUrls?.local[0] as string)
  } finally {
    await server.close()
  }
})

test('behind webpack', async ({ page }) => {
  const folder = site('webpack', '<script defer src="main.js"></script>')
  const compiler = webpack({ mode: 'production', context: folder, entry: './entry.js', output: { path: folder } })
  if (!compiler) throw new Error('webpack did not start.')
  const stats = await promisify(compiler.run.bind(compiler))()
  await promisify(compiler.close.bind(compiler))()
  expect(stats?.toJson({ errors: true, all: false }).errors).toEqual([])
  await expectAnswer(page, 'webpack/')
})

test('behind esbuild', async ({ page }) => {
  const folder = site('esbuild', '<script defer src="main.js"></script>')
  const { warnings } = await esbuild.build({
    absWorkingDir: folder,
    entryPoints: ['entry.js'],
    outfile: 'main.js',
    bundle: true,
    minify: true,
    logLevel: 'silent',
  })
  expect(warnings).toEqual([])
  await expectAnswer(page, 'esbuild/')
})

function node(...args: string[]): string {
  return execFileSync(process.execPath, args, {
    cwd: elsewhere,
    encoding: 'utf8',
    timeout: 60_000,
    env: { ...process.env, FORCE_COLOR: '0' },
  })
}

test('in Node, with vectors and without; a classifier that is not closed lets the process end', async () => {
  const { hexahedra, expected } = await fixture()
  site('node', '')
  writeFileSync(join(elsewhere, 'node/hexahedra.json'), JSON.stringify(hexahedra))
  writeFileSync(
    join(elsewhere, 'node/main.js'),
    `import { readFileSync } from 'node:fs'
     const before = Object.keys(globalThis).length
     const { startClassifier } = await import('hexlens/batch')
     const added = Object.keys(globalThis).length - before
     const { answer } = await import('./answer.js')
     const answered = await answer(JSON.parse(readFileSync('node/hexahedra.json', 'utf8')))
     const left = await startClassifier()
     const { ok } = await left.classify(new Float64Array(24), null)
     console.log(JSON.stringify({ answered, added, ok }))`,
  )
  const printed = node('node/main.js')
  expect(JSON.parse(printed)).toEqual({ answered: expected, added: 0, ok: true })
  writeFileSync(
    join(elsewhere, 'node/no-vectors.js'),
    `const { compile } = WebAssembly
     let refused = 0
     WebAssembly.compile = async bytes => {
       if (refused++ % 2 === 0) throw new WebAssembly.CompileError('no vectors here')
       return compile(bytes)
     }`,
  )
  expect(node('--import', './node/no-vectors.js', 'node/main.js')).toBe(printed)
})

test('the lines of docs/batches.md answer', () => {
  const section = readFileSync(join(root, 'docs/batches.md'), 'utf8')
    .split(/^## /m)
    .find(part => part.startsWith('In JavaScript'))
  const lines = section?.split('\n').filter(line => line.startsWith('    '))
  const snippet = lines?.slice(0, 1 + lines.findIndex(line => line.includes('close()'))).join('\n')
  const run = (points: string, cells = '0, 1, 2, 3, 4, 5, 6, 7') => {
    const given = `const points = new Float64Array([${points}])
      const cells = new Uint32Array([${cells}])
      const [signal, onProgress] = [AbortSignal.timeout(60_000), () => {}]`
    writeFileSync(join(elsewhere, 'documented.js'), `${given}\n${snippet}`)
    return node('documented.js')
  }
  const cube = '0,0,0, 1,0,0, 1,1,0, 0,1,0, 0,0,1, 1,0,1, 1,1,1, 0,1,1'
  expect(run(cube)).toMatch(/^1 Uint8Array\(1\) \[ 1 \] \{\s*values: Float64Array\(1\) \[ 1 \]/)
  expect(run(cube.replace('1,1,0', '1,1,NaN'))).toMatch(
    /^0 Uint8Array\(1\) \[ 0 \] \{\s*values: Float64Array\(1\) \[ NaN \]/,
  )
  expect(run(cube, '0, 1, 2')).toBe('Cell 0 is incomplete: eight indices make one.\n')
})

test('its types are whole', () => {
  writeFileSync(
    join(elsewhere, 'batch.ts'),
    `import { type CellChunk, type Classification, type Classifier, startClassifier } from 'hexlens/batch'
     const classifier: Classifier = await startClassifier({ workers: 2, workerUrl: new URL('https://example.org/') })
     const options = { minima: true, signal: AbortSignal.timeout(1000), onProgress: ({ done }: { done: number }) => done }
     const result = await classifier.classify(new Float64Array(24), new Uint32Array(8), options)
     export const valid: Uint8Array | string = result.ok ? result.value.valid : result.error.message
     function* chunks(): Generator<CellChunk> { yield { points: new Float64Array(24) } }
     for await (const one of classifier.stream(chunks(), { minima: true, handOver: true }))
       if (one.ok) { const { minima, validCount }: Classification<{ minima: true }> = one.value; console.log(minima.values, validCount) }
     const asked = await classifier.classify(new Float64Array(24), null, { minima: true, classes: true })
     if (asked.ok) { console.log(asked.value.minima.values, asked.value.classes.length, asked.value.firstUnanswered) }
     // @ts-expect-error A list that was not asked for is null.
     if (asked.ok) console.log(asked.value.volumes.values)
     // @ts-expect-error Numbers are no list of doubles: the types are there.
     await classifier.classify([0, 1, 2], null)
     classifier.close()`,
  )
  const tsc = (...args: string[]) =>
    node(
      join(root, 'node_modules/typescript/bin/tsc'),
      '--strict',
      '--noEmit',
      '--target',
      'es2022',
      ...args,
      'batch.ts',
    )
  tsc('--module', 'nodenext', '--types', '')
  // A program for Node is compiled without a DOM.
  tsc('--module', 'nodenext', '--lib', 'es2023', '--typeRoots', join(root, 'node_modules/@types'), '--types', 'node')
  tsc('--module', 'esnext', '--moduleResolution', 'bundler', '--types', '', '--exactOptionalPropertyTypes')
})

/** A script that is the package's worker, and does something else when its second piece arrives. */
function mischief(name: string, action: string): string {
  writeFileSync(
    join(elsewhere, name),
    `import './node_modules/hexlens/dist/hexlens.batch-worker.js'
     const own = globalThis.onmessage
     let pieces = 0
     globalThis.onmessage = event => {
       if (event.data.kind === 'classify' && ++pieces === 2) { ${action} } else own(event)
     }`,
  )
  return name
}

interface Outcome {
  readonly messages: string[]
  readonly workers: number
}

/** Three calls in a page: what each said, and how many workers there were. `end` ends the worker while it has the second. */
function threeCalls(page: Page, { workerUrl, end = false }: { workerUrl?: string; end?: boolean }): Promise<Outcome> {
  return page.evaluate(
    async ({ workerUrl, end }) => {
      const workers: Worker[] = []
      const { Worker: Own } = globalThis
      globalThis.Worker = class extends Own {
        constructor(...args: ConstructorParameters<typeof Worker>) {
          super(...args)
          workers.push(this)
        }
      }
      const { startClassifier } = await import(
        new URL('node_modules/hexlens/dist/hexlens.batch.js', location.href).href
      )
      const messages: string[] = []
      try {
        const classifier = await startClassifier({ workers: 1, ...(workerUrl && { workerUrl }) })
        for (const call of [1, 2, 3]) {
          const asked = classifier.classify(new Float64Array(24), null)
          if (end && call === 2) workers[0]?.terminate()
          messages.push(
            await asked.then(
              ({ value }: { value: { validCount: number } }) => `${value.validCount} valid`,
              (reason: unknown) => String(reason),
            ),
          )
        }
        classifier.close()
      } catch (reason) {
        messages.push(String(reason))
      }
      return { messages, workers: workers.length }
    },
    { workerUrl, end },
  )
}

const ENDED = 'Error: A worker for batches ended before it had answered'

test('a worker that ends, throws, is not there or has no memory rejects the promise, and the next call starts another', async ({
  page,
}) => {
  writeFileSync(join(elsewhere, 'calls.html'), html(''))
  await page.goto('calls.html')
  const lost = (says: string) => ({ messages: ['0 valid', `${ENDED}${says}`, '0 valid'], workers: 2 })
  expect(await threeCalls(page, { end: true })).toEqual(lost(', perhaps for want of memory.'))
  const closing = mischief('closing.js', 'close()')
  expect(await threeCalls(page, { workerUrl: closing })).toEqual(lost(', perhaps for want of memory.'))
  const throwing = mischief('throwing.js', "throw new Error('struck by a test')")
  expect(await threeCalls(page, { workerUrl: throwing })).toEqual(lost(': Uncaught Error: struck by a test'))
  const missing = 'Error: A worker for batches did not start: its script was not loaded from nowhere.js'
  expect(await threeCalls(page, { workerUrl: 'nowhere.js' })).toEqual({ messages: Array(3).fill(missing), workers: 3 })
  writeFileSync(
    join(elsewhere, 'hoarding.js'),
    `import './node_modules/hexlens/dist/hexlens.batch-worker.js'
     globalThis.hoard = []
     try { for (;;) hoard.push(new WebAssembly.Memory({ initial: 1, maximum: 65536 })) } catch {}`,
  )
  const outOfMemory = /^Error: A worker for batches ran out of memory: RangeError: /
  expect(await threeCalls(page, { workerUrl: 'hoarding.js' })).toEqual({
    messages: Array(3).fill(expect.stringMatching(outOfMemory)),
    workers: 3,
  })
})

test('where a policy forbids workers from blob: addresses that is said, and a copy of the script runs', async ({
  page,
}) => {
  const policy = (sources: string) =>
    `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'self' ${sources}">`
  writeFileSync(join(elsewhere, 'no-blob.html'), html('', policy("'wasm-unsafe-eval'")))
  await page.goto('no-blob.html')
  const { messages } = await threeCalls(page, {})
  expect(messages[0]).toMatch(/^Error: A worker for batches did not start: .*Content-Security-Policy.*workerUrl/)
  const workerUrl = 'node_modules/hexlens/dist/hexlens.batch-worker.js'
  expect(await threeCalls(page, { workerUrl })).toEqual({ messages: Array(3).fill('0 valid'), workers: 1 })
  writeFileSync(join(elsewhere, 'no-wasm.html'), html('', policy('blob:')))
  await page.goto('no-wasm.html')
  const refused = await threeCalls(page, {})
  expect(refused).toEqual({
    messages: [expect.stringMatching(/^Error: Batches need WebAssembly, which may/)],
    workers: 0,
  })
})
