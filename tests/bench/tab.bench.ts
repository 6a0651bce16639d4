/**
 * Ten million random elements through a tab: the page's search, with as many workers as it takes, in Chromium. What is counted is the memory
 * that the tab's process has to itself, as a browser's task manager shows it, before the search and at its most.
 */
import { execFileSync } from 'node:child_process'
import { cpus, loadavg } from 'node:os'
import { memoryOfTabs, served, startedChromium } from './tab'

const ELEMENTS = 10_000_000
const MEGABYTE = 2 ** 20
/** Numbers of any length about the unit cube, corners positive and yet invalid. */
const SEARCH = 'search.html?find=corners&grid=free&sigma=0.3'

export async function main(): Promise<void> {
  execFileSync(process.execPath, ['tools/build.mjs'], { stdio: 'ignore' })
  const { server, address } = await served('dist/app')
  const browser = await startedChromium()
  console.log(`${cpus()[0]?.model.trim()}, Chromium ${browser.version()}, load ${loadavg()[0]?.toFixed(1)}`)
  const tab = await browser.newPage()
  await tab.goto(`${address}/${SEARCH}`)
  await tab.getByRole('button', { name: 'Start' }).waitFor()
  await tab.waitForTimeout(3000)
  const own = await memoryOfTabs(browser)
  const before = own()
  await tab.getByRole('button', { name: 'Start' }).click()
  let [most, counts] = [before, '']
  while (elementsOf(counts) < ELEMENTS) {
    await tab.waitForTimeout(100)
    most = Math.max(most, own())
    counts = (await tab.locator('.counts').textContent()) ?? ''
  }
  console.log(`${counts}: ${megabytes(before)} before, ${megabytes(most)} at most`)
  await browser.close()
  server.close()
}

function elementsOf(counts: string): number {
  return Number(/^([\d,]+) elements/.exec(counts)?.[1]?.replaceAll(',', '') ?? 0)
}

function megabytes(bytes: number): string {
  return `${(bytes / MEGABYTE).toFixed(0)} MB`
}
