/**
 * Main-thread script of one drag frame in Chromium, by what is open: what the browser itself counts as the page's scripts (event
 * handlers and animation frame callbacks) from one move of the pointer to the end of its frame. It is the thread's processor time: waiting
 * for a software renderer, which on a machine without a GPU takes the same cores, is not counted, nor is rasterization.
 */
import { spawn } from 'node:child_process'
import { cpus, loadavg } from 'node:os'
import { type CDPSession, chromium, type Page } from '@playwright/test'
import { findChromium } from '../../tools/chromium.mjs'

const PORT = 41736
const MOVES = 120
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
    const executablePath = await findChromium()
    const browser = await chromium.launch({ ...(executablePath ? { executablePath } : {}), args: ARGUMENTS })
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } })
    await reach(page)
    const devtools = await page.context().newCDPSession(page)
    await devtools.send('Performance.enable', { timeDomain: 'threadTicks' })
    console.log(
      `${cpus()[0]?.model}, Chromium ${browser.version()}, load ${loadavg()[0]?.toFixed(1)}: ${MOVES} moves each`,
    )
    for (const [name, buttons] of STAGES) {
      for (const button of buttons) await page.getByRole('button', { name: button, exact: true }).click()
      await page.waitForTimeout(1000)
      const times = await drag(page, devtools)
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

/** Drags vertex 6 to and fro, a frame a move; the frames' times in ms, ascending. */
async function drag(page: Page, devtools: CDPSession): Promise<number[]> {
  const handle = await page.locator('hex-lens .scene-pane .handle').nth(6).boundingBox()
  if (handle === null) throw new Error('There is no handle of vertex 6.')
  const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  const times: number[] = []
  for (let n = 0; n < MOVES; ++n) {
    const before = await scriptSeconds(devtools)
    await page.mouse.move(x + 30 * Math.sin(n / 7), y + 20 * Math.sin(n / 11))
    await page.evaluate(() => new Promise<void>(done => requestAnimationFrame(() => setTimeout(done))))
    times.push(1000 * ((await scriptSeconds(devtools)) - before))
  }
  await page.keyboard.press('Escape')
  await page.mouse.up()
  return times.sort((a, b) => a - b)
}

async function scriptSeconds(devtools: CDPSession): Promise<number> {
  const { metrics } = await devtools.send('Performance.getMetrics')
  return metrics.find(({ name }) => name === 'ScriptDuration')?.value ?? Number.NaN
}
