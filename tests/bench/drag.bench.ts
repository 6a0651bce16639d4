/**
 * Main-thread script of one drag frame in Chromium, by what is open, from the browser's own trace: the event handlers and the animation
 * frame callbacks of a frame that has a move of the pointer in it. It is the thread's processor time: waiting for a software renderer,
 * which on a machine without a GPU takes the same cores, is not counted, nor is rasterization.
 */
import { spawn } from 'node:child_process'
import { cpus, loadavg } from 'node:os'
import { type Browser, chromium, type Page } from '@playwright/test'
import { findInstalledChromium } from '../../tools/chromium.mjs'

const PORT = 41736
const MOVES = 120
/** Milliseconds from move to move, in which a software renderer is done with the last picture and leaves the cores alone. */
const PAUSE = 150
const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']

/** Each opens what is listed on top of what was open before. */
const STAGES: readonly (readonly [string, readonly string[]])[] = [
  ['nothing open', []],
  ['reference cube', ['Reference cube']],
  ['face maps', ['Face maps']],
  ['algorithm', ['Algorithm 1, step by step']],
  ['inside', ['Inside']],
  ['all panels', ['Node order', 'Morph', 'Paste or drop', 'Take away']],
]

export async function main(): Promise<void> {
  const server = spawn(process.execPath, ['tools/start.mjs', '--port', String(PORT), '--out', 'dist/bench'], {
    stdio: 'ignore',
  })
  try {
    const executablePath = await findInstalledChromium()
    const browser = await chromium.launch({ ...(executablePath ? { executablePath } : {}), args: ARGUMENTS })
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } })
    await reach(page)
    console.log(
      `${cpus()[0]?.model}, Chromium ${browser.version()}, load ${loadavg()[0]?.toFixed(1)}: ${MOVES} moves each`,
    )
    for (const [name, buttons] of STAGES) {
      for (const button of buttons) await page.getByRole('button', { name: button, exact: true }).click()
      await page.waitForTimeout(1000)
      const times = await drag(browser, page)
      const at = (part: number) => (times[Math.floor(part * (times.length - 1))] ?? Number.NaN).toFixed(2).padStart(7)
      console.log(`${at(0.5)} ms median ${at(0.9)} ms 90 %  ${name}`)
    }
    await browser.close()
  } finally {
    server.kill()
  }
}

async function reach(page: Page): Promise<void> {
  for (let attempt = 0; ; ++attempt) {
    try {
      await page.goto(`http://127.0.0.1:${PORT}/`)
      await page.getByRole('status', { name: 'Verdict' }).getByText('VALID').first().waitFor()
      return
    } catch (error) {
      if (attempt === 60) throw error
      await page.waitForTimeout(1000)
    }
  }
}

/** Drags vertex 6 to and fro; the frames' times in ms, ascending. */
async function drag(browser: Browser, page: Page): Promise<number[]> {
  const handle = await page.locator('hex-lens .scene-pane .handle').nth(6).boundingBox()
  if (handle === null) throw new Error('There is no handle of vertex 6.')
  const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await browser.startTracing(page, { categories: ['devtools.timeline', 'toplevel'] })
  for (let n = 0; n < MOVES; ++n) {
    await page.mouse.move(x + 30 * Math.sin(n / 7), y + 20 * Math.sin(n / 11))
    await page.waitForTimeout(PAUSE)
  }
  const trace = JSON.parse((await browser.stopTracing()).toString())
  await page.keyboard.press('Escape')
  await page.mouse.up()
  return frameTimes(trace.traceEvents).sort((a, b) => a - b)
}

/** Times in microseconds; `tdur` is the thread's own. */
interface TraceEvent {
  readonly name: string
  readonly pid: number
  readonly tid: number
  readonly ts: number
  readonly dur?: number
  readonly tdur?: number
  readonly args?: { readonly data?: { readonly type?: string } }
}

/** The scripts of each of the main thread's tasks that has both a move of the pointer and an animation frame, in ms. */
function frameTimes(events: readonly TraceEvent[]): number[] {
  const frame = events.find(({ name }) => name === 'FireAnimationFrame')
  const times: number[] = []
  let task = { script: 0, hasMove: false, hasFrame: false }
  let end = 0 // of the last script: what it calls is in it
  const close = () => {
    if (task.hasMove && task.hasFrame) times.push(task.script / 1000)
  }
  const ours = events.filter(({ pid, tid }) => pid === frame?.pid && tid === frame.tid).sort((a, b) => a.ts - b.ts)
  for (const { name, ts, dur = 0, tdur = Number.NaN, args } of ours) {
    if (name.endsWith('RunTask')) {
      close()
      task = { script: 0, hasMove: false, hasFrame: false }
    }
    if (ts < end || !['EventDispatch', 'FireAnimationFrame', 'FunctionCall'].includes(name)) continue
    end = ts + dur
    task.script += tdur
    task.hasMove ||= args?.data?.type === 'pointermove'
    task.hasFrame ||= name === 'FireAnimationFrame'
  }
  close()
  return times
}
