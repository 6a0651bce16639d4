/**
 * The one-file widget in Chromium, over http on this machine: from the first statement of the script to the first number (the report of the first
 * `hex-verdict`), layout shifts, and long tasks: the browser's own, over 50 ms, after `load`. A tab of its own each time, all caches cold.
 */

import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { cpus, loadavg } from 'node:os'
import { chromium } from '@playwright/test'
import { findInstalledChromium } from '../../tools/chromium.mjs'

const FOLDER = 'dist'
const VISITS = 15
const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']

const page = (script: string) => `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Widget</title>
<link rel="icon" href="data:,"><script src="watch.js"></script>${script}</head>
<body><p>Words before.</p><hex-lens style="display: block; width: 100%; height: 560px"></hex-lens><p>Words after.</p></body></html>`

const SCRIPTS = {
  'es.html': '<script type="module" src="hexlens.es.js"></script>',
  'iife.html': '<script defer src="hexlens.iife.js"></script>',
}

/** Runs in the page. */
const WATCH = `
  globalThis.seen = { firstNumber: null, shifts: 0, longTasks: [] }
  document.addEventListener('hex-verdict', event => {
    seen.firstNumber ??= event.target.report && performance.now()
  }, { capture: true })
  new PerformanceObserver(list => {
    for (const { value } of list.getEntries()) seen.shifts += value
  }).observe({ type: 'layout-shift', buffered: true })
  new PerformanceObserver(list => {
    for (const { startTime, duration } of list.getEntries()) seen.longTasks.push({ startTime, duration })
  }).observe({ type: 'longtask', buffered: true })
`

interface Visit {
  readonly firstNumber: number
  readonly start: number
  readonly shifts: number
  readonly longTasks: readonly number[]
}

export async function main(): Promise<void> {
  execFileSync(process.execPath, ['tools/build.mjs'], { stdio: 'ignore' })
  const server = createServer((request, response) => {
    const name = (request.url ?? '').slice(1)
    const script = SCRIPTS[name as keyof typeof SCRIPTS]
    const isScript = name.endsWith('.js')
    response.setHeader('Content-Type', isScript ? 'text/javascript' : 'text/html')
    if (name === 'watch.js') response.end(WATCH)
    else if (isScript) response.end(`performance.mark('start');${readFileSync(`${FOLDER}/${name}`, 'utf8')}`)
    else if (script) response.end(page(script))
    else response.writeHead(404).end()
  })
  await new Promise<void>(resolve => server.listen(0, '127.0.0.1', resolve))
  const { port } = server.address() as { port: number }
  const executablePath = await findInstalledChromium()
  const browser = await chromium.launch({ ...(executablePath ? { executablePath } : {}), args: ARGUMENTS })
  console.log(
    `${cpus()[0]?.model}, Chromium ${browser.version()}, load ${loadavg()[0]?.toFixed(1)}: ${VISITS} visits each`,
  )
  const visits: Record<string, Visit[]> = { 'es.html': [], 'iife.html': [] }
  for (let n = 0; n < VISITS; n++) {
    for (const name of Object.keys(SCRIPTS)) {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 } })
      const tab = await context.newPage()
      await tab.goto(`http://127.0.0.1:${port}/${name}`)
      await tab.waitForFunction(
        () => (globalThis as unknown as { seen: { firstNumber: number | null } }).seen.firstNumber !== null,
      )
      await tab.waitForTimeout(1500)
      visits[name]?.push(await tab.evaluate(look))
      await context.close()
    }
  }
  for (const [name, seen] of Object.entries(visits)) {
    const first = seen.map(({ firstNumber, start }) => firstNumber - start).sort((a, b) => a - b)
    const at = (part: number) => (first[Math.floor(part * (first.length - 1))] ?? Number.NaN).toFixed(0)
    const shifts = Math.max(...seen.map(visit => visit.shifts))
    const long = seen.map(({ longTasks }) => longTasks)
    const longest = Math.max(0, ...long.flat())
    console.log(
      `${name.padEnd(10)} first number ${at(0.5)} ms median, ${at(0)} least, ${at(1)} most; layout shifts ${shifts}; long tasks after load in ${long.filter(tasks => tasks.length > 0).length} visits, longest ${longest.toFixed(0)} ms`,
    )
  }
  await browser.close()
  server.close()
}

/** Runs in the page. */
function look(): Visit {
  const { seen } = globalThis as unknown as {
    seen: { firstNumber: number; shifts: number; longTasks: { startTime: number; duration: number }[] }
  }
  const [mark] = performance.getEntriesByName('start') as [PerformanceEntry]
  const [navigation] = performance.getEntriesByType('navigation') as [PerformanceNavigationTiming]
  return {
    firstNumber: seen.firstNumber,
    start: mark.startTime,
    shifts: seen.shifts,
    longTasks: seen.longTasks
      .filter(({ startTime }) => startTime > navigation.loadEventEnd)
      .map(({ duration }) => duration),
  }
}
