/** The packed files, in Node and in a browser, over http and from file://. */
import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { Lens } from '../e2e/lens'
import { elsewhere, expect, root, test } from './elsewhere'

const dist = 'node_modules/hexlens/dist'

function write(name: string, text: string): string {
  writeFileSync(join(elsewhere, name), text)
  return name
}

function node(...args: string[]): string {
  return execFileSync(process.execPath, args, { cwd: elsewhere, encoding: 'utf8' })
}

const element = (script: string, head = '') =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Elsewhere</title><link rel="icon" href="data:,">${head}${script}</head><body><main><h1>Elsewhere</h1><hex-lens views="all"></hex-lens></main></body></html>`

/** Each panel is asked for and shown: all of them are in the one file. */
async function openEveryPanel(lens: Lens): Promise<void> {
  const headings = lens.page.locator('hex-lens .fold > h2 > button')
  await expect(headings).not.toHaveCount(0)
  for (const heading of await headings.all()) await heading.click()
  for (const body of await lens.page.locator('hex-lens .fold > div').all()) {
    await expect(body).not.toBeEmpty()
    await expect(body).not.toContainText('could not be loaded')
  }
}

test('in Node the core answers without a DOM, by wasm and by its twin alike, and its types are whole', async () => {
  write(
    'core.mjs',
    `import { loadCore, presets, presetVertices, reportJson } from 'hexlens/core'
     import { fileOfBytes, MeshRefusal, readMeshes, verticesOf } from 'hexlens/mesh'
     const core = await loadCore()
     const [mesh] = readMeshes(fileOfBytes('pasted', new TextEncoder().encode(process.argv[2])))
     const vertices = verticesOf(mesh, 0)
     try {
       readMeshes(fileOfBytes('empty', new Uint8Array(0)))
     } catch (error) {
       if (!(error instanceof MeshRefusal)) throw error
     }
     const report = core.analyze(vertices).value
     const certificate = core.certificate(vertices).value
     const proofs = presets.map(preset => core.certificate(presetVertices(preset, () => 0.5)).value.valid)
     console.log(JSON.stringify([report, certificate.valid, proofs, reportJson(report, 'pasted', '0')]))`,
  )
  const pasted = '0 1 0  1 1 -4  1 4 -3  -2 -1 -2  -4 1 4  4 -1 4  4 1 3  -2 3 1'
  const answer = node('core.mjs', pasted)
  const [report, valid, proofs] = JSON.parse(answer)
  expect(report).toMatchObject({ valid: false, decidedBy: 'filter', minimizer: { kind: 'edge' } })
  expect(report.boundaryMinimum).toBeCloseTo(-11.28, 2)
  expect(valid).toBe(false)
  expect(proofs).toContain(true)
  write('no-wasm.mjs', 'delete globalThis.WebAssembly')
  expect(node('--import', './no-wasm.mjs', 'core.mjs', pasted)).toBe(answer)

  write(
    'typed.ts',
    `import { loadCore, type Report } from 'hexlens/core'
     import { fileOfBytes, type Mesh, readMeshes } from 'hexlens/mesh'
     export const meshes: readonly Mesh[] = readMeshes(fileOfBytes('a.vtu', new Uint8Array(8)))
     // @ts-expect-error A mesh has points, not a number of them.
     export const points: number = meshes[0]?.points
     const result = (await loadCore()).analyze([])
     export const report: Report | string = result.ok ? result.value : result.error.code
     // @ts-expect-error A Report is no number: the types are there.
     export const wrong: number = (await loadCore()).analyze([])
     import 'hexlens'
     export const lens = (): number[] => document.createElement('hex-lens').vertices`,
  )
  node(
    join(root, 'node_modules/typescript/bin/tsc'),
    '--strict',
    '--noEmit',
    '--module',
    'nodenext',
    '--types',
    '',
    'typed.ts',
  )
})

test('imported on a server the element does no harm, as a module or as a script', () => {
  write(
    'server.mjs',
    `const before = Object.keys(globalThis).length
     const { HexLens } = await import('hexlens')
     await import('./${dist}/hexlens.iife.js')
     console.log(JSON.stringify([typeof HexLens, Object.keys(globalThis).length - before]))`,
  )
  expect(JSON.parse(node('server.mjs'))).toEqual(['function', 0])
})

test('the command line is the same', () => {
  const vectors = join(root, 'tests/vectors/depth_guard_false_negatives.json')
  const bin = join(elsewhere, 'node_modules/.bin/hexlens')
  const verdicts = JSON.parse(execFileSync(bin, ['analyze', vectors], { encoding: 'utf8' }))
  expect(verdicts.length).toBe(JSON.parse(readFileSync(vectors, 'utf8')).length)
  expect(verdicts.every((verdict: { valid: boolean }) => verdict.valid)).toBe(true)
})

test('from file:// one script is all there is', async ({ page }) => {
  const complaints: string[] = []
  const asked: string[] = []
  page.on('pageerror', error => complaints.push(error.message))
  page.on('console', message => void (message.type() === 'error' && complaints.push(message.text())))
  page.on('request', request => asked.push(request.url()))
  write(
    'file.html',
    element(
      '<script>var globals; globals = new Set(Object.keys(window))</script>',
      `<script defer src="${dist}/hexlens.iife.js"></script>`,
    ),
  )
  const lens = new Lens(page)
  await lens.open(pathToFileURL(join(elsewhere, 'file.html')).href)
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await openEveryPanel(lens)
  expect(asked.filter(url => url.startsWith('file:')).map(url => url.split('/').at(-1))).toEqual([
    'file.html',
    'hexlens.iife.js',
  ])
  expect(
    await page.evaluate(() =>
      Object.keys(window).filter(name => !(globalThis as unknown as { globals: Set<string> }).globals.has(name)),
    ),
  ).toEqual([])
  expect(complaints).toEqual([])
})

test('a language is a script of its own, that may come after the element', async ({ lens, page, served }) => {
  const german = '<script type="module">import "./node_modules/hexlens/dist/hexlens.lang.de.js"</script>'
  write(
    'german.html',
    element(
      `<script defer src="${dist}/hexlens.iife.js"></script>${german}<script defer src="${dist}/hexlens.lang.zh.js"></script>`,
    ).replace('lang="en"', 'lang="de"'),
  )
  await page.goto(`${served}/german.html`)
  await expect(lens.element.locator('.word')).toHaveText('UNGÜLTIG')
  await page.evaluate(() => document.documentElement.setAttribute('lang', 'zh-Hans'))
  await expect(lens.element.locator('.word')).toHaveText('无效')
})

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

/** Offers a text to the element, as if it were pasted. */
async function offer(lens: Lens, text: string): Promise<void> {
  await lens.element.evaluate((element, given) => (element as HTMLElementTagNameMap['hex-lens']).offer(given), text)
}

const readRegion = (lens: Lens) => lens.page.getByRole('region', { name: 'What was read' })

test('what is pasted is read by the worker beside the script, from the same place, from another and from file://', async ({
  page,
  served,
}) => {
  const lens = new Lens(page)
  write('here.html', element(`<script type="module" src="${dist}/hexlens.es.js"></script>`))
  const elsewhereOf = served.replace('127.0.0.1', 'localhost')
  write('there.html', element(`<script defer src="${elsewhereOf}/${dist}/hexlens.iife.js"></script>`))
  for (const address of [
    `${served}/here.html`,
    `${served}/there.html`,
    pathToFileURL(join(elsewhere, 'file.html')).href,
  ]) {
    if (address.startsWith('file:'))
      write('file.html', element(`<script defer src="${dist}/hexlens.iife.js"></script>`))
    await lens.open(address)
    await offer(lens, cube.join(' '))
    await expect(readRegion(lens), address).toContainText('Eight points taken in the order of the text.')
    expect(await lens.vertices()).toEqual(cube)
  }
})

test('HDF5 is read with the file for it, from the same place and from another', async ({ page, served }) => {
  const lens = new Lens(page)
  const from = served.replace('127.0.0.1', 'localhost')
  write('here.html', element(`<script type="module" src="${dist}/hexlens.es.js"></script>`))
  write('there.html', element(`<script defer src="${from}/${dist}/hexlens.iife.js"></script>`))
  const bytes = readFileSync(join(root, 'tests/unit/hdf5/zones.cgns')).toString('base64')
  const drop = () =>
    lens.element.evaluate((own, base64) => {
      const file = new File([Uint8Array.from(atob(base64), character => character.charCodeAt(0))], 'zones.cgns')
      ;(own as HTMLElementTagNameMap['hex-lens']).offer([file])
    }, bytes)
  for (const name of ['here.html', 'there.html']) {
    await lens.open(`${served}/${name}`)
    await drop()
    await expect(readRegion(lens), name).toContainText('6 hexahedra, all VALID. Read as CGNS.')
  }
  write('file.html', element(`<script defer src="${dist}/hexlens.iife.js"></script>`))
  await lens.open(pathToFileURL(join(elsewhere, 'file.html')).href)
  await drop()
  await expect(lens.page.getByRole('alert')).toContainText('The reader of HDF5 files was not loaded')
})

test.describe('where the worker is not beside the script', () => {
  test.use({ expectedErrors: /Failed to load resource/ })

  test('a sentence says so, and where it is can be said', async ({ lens }) => {
    mkdirSync(join(elsewhere, 'alone'), { recursive: true })
    cpSync(join(elsewhere, dist, 'hexlens.es.js'), join(elsewhere, 'alone/hexlens.es.js'))
    write(
      'alone.html',
      element(
        `<script type="module">import { setMeshWorker } from './alone/hexlens.es.js'; globalThis.setMeshWorker = setMeshWorker</script>`,
      ),
    )
    await lens.open('alone.html')
    await offer(lens, cube.join(' '))
    await expect(lens.page.getByRole('alert')).toContainText(
      'Nothing was read: the worker that reads did not start: hexlens.mesh-worker.js was not loaded from beside the script',
    )
    await lens.page.evaluate(
      address => (globalThis as unknown as { setMeshWorker(at: string): void }).setMeshWorker(address),
      `${dist}/hexlens.mesh-worker.js`,
    )
    await offer(lens, cube.join(' '))
    await expect(readRegion(lens)).toContainText('Eight points taken in the order of the text.')
  })
})

test.describe('under a strict policy', () => {
  test.use({ expectedErrors: /violates the following|policy: script-src forbids wasm-eval/ })

  test('the one module runs, and the core in a worker, with the twin beside them', async ({ lens, page }) => {
    const policy =
      "default-src 'none'; script-src 'self'; img-src data: blob:; require-trusted-types-for 'script'; trusted-types lit-html hexlens 'allow-duplicates'"
    write(
      'policy.html',
      element(
        `<script type="module" src="${dist}/hexlens.es.js"></script>`,
        `<meta http-equiv="Content-Security-Policy" content="${policy}">`,
      ),
    )
    const twin = page.waitForResponse(/hexlens\.twin\.js$/)
    await lens.open('policy.html')
    expect((await twin).ok()).toBe(true)
    await expect(lens.verdict).toHaveText(/^INVALID/)
    const { vertices } = await lens.element.evaluate(element => {
      const { vertices } = element as HTMLElementTagNameMap['hex-lens']
      return { vertices }
    })
    await offer(
      lens,
      JSON.stringify([
        { name: 'a', vertices: cube },
        { name: 'b', vertices },
      ]),
    )
    await expect(readRegion(lens)).toContainText('2 hexahedra, 1 INVALID, 1 valid.')
    // A second copy gives the class of the first.
    const second = await page.evaluate(async script => {
      const { HexLens } = await import(script)
      return [HexLens === customElements.get('hex-lens'), new HexLens().vertices.length]
    }, `/${dist}/hexlens.es.js?again`)
    expect(second).toEqual([true, 24])
    write(
      'worker.js',
      `import { loadCore } from './${dist}/hexlens.core.js'
       addEventListener('message', async ({ data }) => postMessage((await loadCore()).analyze(data).value))`,
    )
    const [inWorker, inElement] = await lens.element.evaluate(async element => {
      const { report, vertices } = element as HTMLElementTagNameMap['hex-lens']
      const { trustedTypes } = globalThis as unknown as {
        trustedTypes: { createPolicy(name: string, rules: object): { createScriptURL(own: string): string } }
      }
      const policy = trustedTypes.createPolicy('hexlens', { createScriptURL: (own: string) => own })
      const worker = new Worker(policy.createScriptURL('worker.js'), { type: 'module' })
      const answer = new Promise(resolve => {
        worker.onmessage = ({ data }) => resolve(data)
      })
      worker.postMessage(vertices)
      return [await answer, report]
    })
    expect(inWorker).toEqual(inElement)
  })
})

test('with three.js from the page there is one of it', async ({ lens, page }) => {
  cpSync(join(root, 'node_modules/three/build'), join(elsewhere, 'three/build'), { recursive: true })
  const imports = {
    three: './three/build/three.module.js',
    hexlens: `./${dist}/hexlens.three.js`,
  }
  const modules = `<script type="importmap">${JSON.stringify({ imports })}</script>
    <script type="module">import { REVISION } from 'three'; import 'hexlens'; document.title = REVISION</script>`
  write('three.html', element(modules))
  await lens.open('three.html')
  await expect(page).toHaveTitle(/^\d+$/)
  await expect(lens.verdict).toHaveText(/^INVALID/)
  expect(await page.evaluate(() => (window as unknown as { __THREE__: string }).__THREE__)).toBe(await page.title())
})

test('the page works under any path', async ({ lens }) => {
  cpSync(join(elsewhere, dist, 'app'), join(elsewhere, 'some/where/else'), { recursive: true })
  await lens.open('some/where/else/')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await lens.button('Take away').click()
  await expect(lens.button('Copy Python')).toBeVisible()
})
