/**
 * Opening a mesh on the built page Mesh beside PyVista, in turns: from the choice of the file until the sentence and the worst ten are
 * there, and until the picture is; the tab's memory; long tasks; and faces joined to neighbours, in Node.
 *
 *     --rounds=N;  --rows=NAME,...   rows whose names have one of these;  --built   the page as it was built last
 */
import { type ChildProcess, spawn } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { availableParallelism, cpus, loadavg } from 'node:os'
import { join } from 'node:path'
import { createInterface } from 'node:readline'
import type { Browser, Page } from '@playwright/test'
import { build } from 'vite'
import type * as Neighbours from '../../web/mesh/neighbours'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { folder, installPeers, must, python, root, script, versionsOf } from './peers'
import { memoryOfTabs, served, startedChromium } from './tab'

const ROUNDS = 7
const APP = 'dist/bench-mesh'
const VITE = ['node_modules/vite/bin/vite.js', 'build', '--config', 'vite.config.ts', '--logLevel', 'warn']
const MEGABYTE = 2 ** 20
const FILES_IN_A_ROW = 10
/** Milliseconds. */
const REST = 1500
const SAMPLING = 15
const PATIENCE = 120_000

/** Ten rows of the list are seen. */
const VIEWPORT = { width: 1440, height: 1200 }

/** A question to both: the worst ten of a file, or its picture. */
interface Row {
  readonly name: string
  readonly file: string
  readonly hexahedra: number
  readonly job: 'list' | 'picture'
  /** As the tab says it; null for the machine's own. */
  readonly cores: number | null
}

const MILLION = 1_000_000
const ROWS: readonly Row[] = [
  { name: 'worst ten, 1M raw', file: 'raw.vtu', hexahedra: MILLION, job: 'list', cores: null },
  { name: 'the same, one worker', file: 'raw.vtu', hexahedra: MILLION, job: 'list', cores: 1 },
  { name: 'noise 0.3', file: 'invalid.vtu', hexahedra: MILLION, job: 'list', cores: null },
  { name: 'points and cells shuffled', file: 'shuffled.vtu', hexahedra: MILLION, job: 'list', cores: null },
  { name: 'pyvista.save()', file: 'saved.vtu', hexahedra: MILLION, job: 'list', cores: null },
  { name: 'first picture, 1M raw', file: 'raw.vtu', hexahedra: MILLION, job: 'picture', cores: null },
  { name: '5M raw', file: 'five.vtu', hexahedra: 5 * MILLION, job: 'list', cores: null },
]

/** Names of what is measured without PyVista. */
const SLICE = 'slice'
const SLIDES = 16
const TEN_FILES = 'ten files'
const NEIGHBOURS = 'neighbours'

/** Milliseconds from the choice of the file, and bytes. */
interface Visit {
  readonly list: number
  readonly picture: number
  readonly longTasks: readonly number[]
}

export async function main(options: readonly string[]): Promise<void> {
  const optionOf = (name: string) => options.find(option => option.startsWith(`--${name}=`))?.slice(name.length + 3)
  const rounds = Number(optionOf('rounds') ?? ROUNDS)
  const wanted = optionOf('rows')?.split(',') ?? ['']
  const isWanted = (name: string) => wanted.some(part => name.includes(part))
  const rows = ROWS.filter(({ name }) => isWanted(name))
  installPeers()
  const files = join(folder, 'mesh')
  process.stderr.write(`bench: writing what is missing in ${files}\n`)
  must(python, [script('mesh_files.py'), files])
  if (!options.includes('--built')) must(process.execPath, [...VITE, '--outDir', join(root, APP)])
  const { server, address } = await served(join(root, APP))
  const peer = await startedPeer()
  const browser = await startedChromium()
  const load = loadavg()[0]?.toFixed(1)
  const machine = `${cpus()[0]?.model.trim()}, ${availableParallelism()} cores, load ${load}`
  console.log(`${machine}; Chromium ${browser.version()}; Node ${process.version}; ${versionsOf(['pyvista', 'vtk'])}\n`)
  try {
    if (rows.length > 0) await compare(rows, { rounds, files, address, peer, browser })
    if (isWanted(TEN_FILES)) await inARow(browser, address, join(files, 'raw.vtu'))
    if (isWanted(SLICE)) await sliding(browser, address, join(files, 'raw.vtu'))
    if (isWanted(NEIGHBOURS)) for (const name of ['raw.vtu', 'shuffled.vtu']) await join1M(join(files, name), rounds)
  } finally {
    await browser.close()
    peer.process.kill()
    server.close()
  }
}

interface Surroundings {
  readonly rounds: number
  readonly files: string
  readonly address: string
  readonly peer: Peer
  readonly browser: Browser
}

async function compare(rows: readonly Row[], { rounds, files, address, peer, browser }: Surroundings): Promise<void> {
  const visits = rows.map((): Visit[] => [])
  const peers = rows.map((): number[] => [])
  const memories = rows.map(() => 0)
  // The first round starts what is started once, and looks at the memory, which takes time: it is not counted.
  for (let round = 0; round <= rounds; ++round)
    for (const [i, row] of rows.entries()) {
      const path = join(files, row.file)
      const here = async () => {
        if (round > 0) visits[i]?.push(await opened(browser, address, path, row))
        else memories[i] = await memoryOf(browser, address, path, row)
      }
      const there = async () => {
        const milliseconds = await peer.ask(row.job, path)
        if (round > 0) peers[i]?.push(milliseconds)
      }
      for (const turn of round % 2 ? [here, there] : [there, here]) await turn()
      process.stderr.write('.')
    }
  process.stderr.write('\n')
  console.log('| from the choice of the file | Hexlens, ms | PyVista, ms | ratio | tab, MB | longest task, ms |')
  console.log('| --- | ---: | ---: | ---: | ---: | ---: |')
  for (const [i, { name, job }] of rows.entries()) {
    const own = visits[i] as Visit[]
    const here = median(own.map(visit => visit[job]))
    const there = median(peers[i] as number[])
    const memory = Math.round((memories[i] as number) / MEGABYTE)
    const longest = Math.round(Math.max(0, ...own.flatMap(({ longTasks }) => longTasks)))
    console.log(
      `| ${name} | ${here.toFixed(0)} | ${there.toFixed(0)} | ${(here / there).toFixed(2)} | ${memory} | ${longest} |`,
    )
  }
}

/** The times that the page's script has noted, and whom it tells. */
interface Seen {
  /** The last large upload, and the last large drawing. */
  uploaded: number
  drawn: number
  begun: number
  list: number
  picture: number
  longTasks: { startTime: number; duration: number }[]
  tell: Partial<Record<Row['job'], () => void>>
}

async function prepared(browser: Browser, address: string, cores: number | null): Promise<Page> {
  const context = await browser.newContext({ viewport: VIEWPORT })
  const page = await context.newPage()
  await page.addInitScript(watch)
  // The browser's own override does not reach workers.
  if (cores !== null)
    await page.route('**/assets/worker-*.js', async route => {
      const response = await route.fetch()
      const before = `Object.defineProperty(navigator, 'hardwareConcurrency', { value: ${cores} });`
      await route.fulfill({ response, body: before + (await response.text()) })
    })
  await page.goto(`${address}/mesh.html`)
  await page.waitForFunction(() => (globalThis as unknown as { seen: Seen }).seen.picture > 0)
  await page.waitForTimeout(REST)
  return page
}

async function opened(browser: Browser, address: string, path: string, row: Row): Promise<Visit> {
  const page = await prepared(browser, address, row.cores)
  const visit = await choose(page, path, row)
  await page.context().close()
  return visit
}

/** The most that the tab has meanwhile. */
async function memoryOf(browser: Browser, address: string, path: string, row: Row): Promise<number> {
  const page = await prepared(browser, address, row.cores)
  const own = await memoryOfTabs(browser)
  let most = own()
  const sampling = setInterval(() => {
    most = Math.max(most, own())
  }, SAMPLING)
  await choose(page, path, row).finally(() => clearInterval(sampling))
  await page.context().close()
  return most
}

async function choose(page: Page, path: string, { hexahedra, job }: Row): Promise<Visit> {
  await page.evaluate(expect, { words: hexahedra.toLocaleString('en') })
  // A function that is asked again and again would have the page make frames.
  const there = page.evaluate(told, { job, within: PATIENCE })
  await page.locator('input[type=file]').setInputFiles(path)
  await there
  // Long tasks are told of when they are over.
  await page.waitForTimeout(job === 'picture' ? REST : 0)
  const { begun, list, picture, longTasks } = await page.evaluate(() => {
    const { begun, list, picture, longTasks } = (globalThis as unknown as { seen: Seen }).seen
    return { begun, list, picture, longTasks }
  })
  const end = picture > 0 ? picture : list
  const before = longTasks.filter(({ startTime }) => startTime >= begun && startTime < end)
  return { list: list - begun, picture: picture - begun, longTasks: before.map(task => task.duration) }
}

/** Runs in the page before its own scripts. A picture is there when the first large drawing behind the list has been rendered. */
function watch(): void {
  const LARGE = 10_000
  const seen: Seen = { uploaded: 0, drawn: 0, begun: 0, list: 0, picture: 0, longTasks: [], tell: {} }
  Object.assign(globalThis, { seen })
  document.addEventListener(
    'change',
    ({ target }) => {
      if (target instanceof HTMLInputElement && target.type === 'file') seen.begun = performance.now()
    },
    { capture: true },
  )
  new PerformanceObserver(list => {
    for (const { startTime, duration } of list.getEntries()) seen.longTasks.push({ startTime, duration })
  }).observe({ entryTypes: ['longtask'] })
  let isUnderWay = false
  function drawn(gl: WebGL2RenderingContext, count: number): void {
    if (count >= LARGE) seen.drawn = performance.now()
    if (count < LARGE || isUnderWay || seen.picture > 0 || (seen.begun > 0 && seen.list === 0)) return
    isUnderWay = true
    queueMicrotask(() => {
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
      seen.picture = performance.now()
      seen.tell.picture?.()
      isUnderWay = false
    })
  }
  const { bufferData, bufferSubData } = WebGL2RenderingContext.prototype
  const uploaded = (given: readonly unknown[]) => {
    if (given.some(each => ArrayBuffer.isView(each) && each.byteLength > LARGE)) seen.uploaded = performance.now()
  }
  Object.assign(WebGL2RenderingContext.prototype, {
    bufferData(this: WebGL2RenderingContext, ...given: Parameters<typeof bufferData>) {
      uploaded(given)
      bufferData.apply(this, given)
    },
    bufferSubData(this: WebGL2RenderingContext, ...given: Parameters<typeof bufferSubData>) {
      uploaded(given)
      bufferSubData.apply(this, given)
    },
  })
  const { drawArrays, drawElements, drawArraysInstanced, drawElementsInstanced } = WebGL2RenderingContext.prototype
  Object.assign(WebGL2RenderingContext.prototype, {
    drawArrays(this: WebGL2RenderingContext, ...given: Parameters<typeof drawArrays>) {
      drawArrays.apply(this, given)
      drawn(this, given[2])
    },
    drawElements(this: WebGL2RenderingContext, ...given: Parameters<typeof drawElements>) {
      drawElements.apply(this, given)
      drawn(this, given[1])
    },
    drawArraysInstanced(this: WebGL2RenderingContext, ...given: Parameters<typeof drawArraysInstanced>) {
      drawArraysInstanced.apply(this, given)
      drawn(this, given[2] * given[3])
    },
    drawElementsInstanced(this: WebGL2RenderingContext, ...given: Parameters<typeof drawElementsInstanced>) {
      drawElementsInstanced.apply(this, given)
      drawn(this, given[1] * given[4])
    },
  })
}

/** Runs in the page: resolves when it is there. */
function told({ job, within }: { job: Row['job']; within: number }): Promise<void> {
  const { seen } = globalThis as unknown as { seen: Seen }
  return new Promise((resolve, reject) => {
    seen.tell = { [job]: resolve }
    setTimeout(() => reject(new Error(`No ${job} within ${within} ms.`)), within)
  })
}

/** Runs in the page: waits for a sentence with the count of cells, and for ten rows with numbers. */
function expect({ words }: { words: string }): void {
  const { seen } = globalThis as unknown as { seen: Seen }
  Object.assign(seen, { begun: 0, list: 0, picture: 0, longTasks: [] })
  const look = () => {
    if (seen.begun === 0 || !document.querySelector('.headline')?.textContent?.includes(words)) return
    const rows = document.querySelectorAll('[role=row] [role=gridcell].minimum')
    if (rows.length < 10) return
    seen.list = performance.now()
    seen.tell.list?.()
    observer.disconnect()
  }
  const observer = new MutationObserver(look)
  observer.observe(document.body, { subtree: true, childList: true, characterData: true })
}

/** The tab's memory at rest after each of some files, one in the place of the other. */
async function inARow(browser: Browser, address: string, path: string): Promise<void> {
  const page = await prepared(browser, address, null)
  const own = await memoryOfTabs(browser)
  const row: Row = { name: '', file: '', hexahedra: MILLION, job: 'picture', cores: null }
  const atRest: number[] = []
  for (let file = 0; file < FILES_IN_A_ROW; ++file) {
    await choose(page, path, row)
    await page.waitForTimeout(REST)
    atRest.push(own())
  }
  await page.context().close()
  const megabytes = atRest.map(bytes => Math.round(bytes / MEGABYTE)).join(', ')
  console.log(
    `\nThe tab at rest after each of ${FILES_IN_A_ROW} files of a million, one in the place of the other: ${megabytes} MB.`,
  )
}

/** The slice through a million cells, slid by its slider: until the drawing begins, and the script of the page's thread. */
async function sliding(browser: Browser, address: string, path: string): Promise<void> {
  const page = await prepared(browser, address, null)
  const row: Row = { name: '', file: '', hexahedra: MILLION, job: 'picture', cores: null }
  await choose(page, path, row)
  await page.getByRole('button', { name: 'Slice', exact: true }).click()
  await page.waitForTimeout(REST)
  const slides: { drawing: number; script: number }[] = []
  for (let i = 0; i < SLIDES; ++i) {
    await browser.startTracing(page, { categories: TRACED })
    const drawing = await page.evaluate(slide, { to: 0.3 + (0.4 * i) / SLIDES, mark: DRAWN })
    // The renderer in software is not measured.
    await page.waitForTimeout(REST)
    slides.push({ drawing, script: scriptIn(await browser.stopTracing()) })
  }
  await page.context().close()
  // The first makes what the others find.
  const ofEach = (wanted: 'drawing' | 'script') => median(slides.slice(1).map(each => each[wanted])).toFixed(1)
  console.log(
    `\nThe slice through a million cells, slid: ${ofEach('drawing')} ms until it is drawn, ${ofEach('script')} ms of script.`,
  )
}

const TRACED = ['v8', 'devtools.timeline', 'blink.user_timing', '__metadata']
const DRAWN = 'drawn'
/** All that calls JavaScript: listeners, frames, messages, and promises that are kept. */
const CALLS = /^(v8\.callFunction|FunctionCall|RunMicrotasks|V8\.RunMicrotasks)$/

interface Traced {
  readonly name: string
  readonly pid: number
  readonly tid: number
  readonly ts: number
  readonly dur?: number
  readonly args: { readonly name?: string }
}

/** Milliseconds of JavaScript on the page's thread until it is drawn; the protocol's own count leaves out what follows a message. */
function scriptIn(trace: Buffer): number {
  const { traceEvents: events } = JSON.parse(trace.toString()) as { traceEvents: Traced[] }
  const threadOf = ({ pid, tid }: Traced) => `${pid} ${tid}`
  const own = new Set(
    events.filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain').map(threadOf),
  )
  let [sum, end] = [0, 0]
  const drawn = events.find(({ name }) => name === DRAWN)?.ts ?? Number.NaN
  const calls = events.filter(event => CALLS.test(event.name) && own.has(threadOf(event)) && event.ts < drawn)
  for (const { ts, dur = 0 } of calls.sort((a, b) => a.ts - b.ts)) {
    sum += Math.max(0, ts + dur - Math.max(ts, end))
    end = Math.max(end, ts + dur)
  }
  return sum / 1000
}

/** Runs in the page: milliseconds from the slider's event until what came from the worker is drawn. */
async function slide({ to, mark }: { to: number; mark: string }): Promise<number> {
  const { seen } = globalThis as unknown as { seen: Seen }
  const slider = document.querySelector('.bar input[type=range]') as HTMLInputElement
  const { min, max } = slider
  const begun = performance.now()
  slider.value = String(Number(min) + to * (Number(max) - Number(min)))
  slider.dispatchEvent(new Event('input', { bubbles: true }))
  while (seen.uploaded < begun || seen.drawn < seen.uploaded)
    await new Promise(resolve => requestAnimationFrame(resolve))
  performance.mark(mark)
  return seen.drawn - begun
}

/** As it is built: modules that are loaded one by one call each other more slowly. */
async function builtNeighbours(): Promise<typeof Neighbours> {
  const entry = join(root, 'web/mesh/neighbours.ts')
  const found = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: { write: false, lib: { entry, formats: ['iife'], name: 'own' } },
  })
  const [first] = (Array.isArray(found) ? found : [found]) as { output: { code: string }[] }[]
  return new Function(`${first?.output[0]?.code}; return own`)()
}

async function join1M(path: string, rounds: number): Promise<void> {
  const { neighboursOf } = await builtNeighbours()
  const [mesh] = readMeshes(fileOfBytes(path, Uint8Array.from(readFileSync(path))))
  if (!mesh) throw new Error(`${path} has no mesh.`)
  const times = Array.from({ length: rounds }, () => {
    const begun = performance.now()
    neighboursOf(mesh.cells, mesh.points.length / 3)
    return performance.now() - begun
  })
  console.log(
    `Boundary faces and neighbours of ${path.slice(path.lastIndexOf('/') + 1)}: ${median(times).toFixed(0)} ms.`,
  )
}

interface Peer {
  readonly process: ChildProcess
  /** Milliseconds. */
  ask(job: Row['job'], path: string): Promise<number>
}

async function startedPeer(): Promise<Peer> {
  const process = spawn(python, [script('mesh_peer.py')], { stdio: ['pipe', 'pipe', 'ignore'] })
  const lines = createInterface({ input: process.stdout })[Symbol.asyncIterator]()
  const line = async () => {
    const { value, done } = await lines.next()
    if (done) throw new Error('PyVista has ended.')
    return value
  }
  await line()
  return {
    process,
    async ask(job, path) {
      process.stdin.write(`${job} ${path}\n`)
      return Number(await line())
    },
  }
}

function median(list: readonly number[]): number {
  return list.toSorted((a, b) => a - b)[list.length >> 1] as number
}
