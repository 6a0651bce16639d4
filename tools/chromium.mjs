// Finds the Chromium that the browser tests drive.

import { existsSync } from 'node:fs'
import { executable, onPath, run } from './run.mjs'

/** The shell first: the same engine at half the processor time, without the browser's own windows. */
const NAMES = ['chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable']
const MAC_PATHS = ['Chromium.app/Contents/MacOS/Chromium', 'Google Chrome.app/Contents/MacOS/Google Chrome']

/** The path of a Chromium that starts: on PATH, a macOS application, or the one Playwright downloaded. */
export async function findChromium() {
  const installed = await findInstalledChromium()
  if (installed) return installed
  const { chromium } = await import('@playwright/test')
  const downloaded = chromium.executablePath()
  return existsSync(downloaded) && (await starts(downloaded)) ? downloaded : undefined
}

/** The same without Playwright's, which Playwright takes where it is given none: modules of Vite's runner can import nothing later. */
export async function findInstalledChromium() {
  const installed = [
    ...NAMES.map(name => onPath(name)),
    ...(process.platform === 'darwin' ? MAC_PATHS.map(path => executable(`/Applications/${path}`)) : []),
  ]
  // Being there is not enough: Ubuntu's chromium-browser is a script that says to use snap.
  for (const path of installed) if (path && (await starts(path))) return path
  return undefined
}

async function starts(path) {
  return (await run(path, ['--version'])).status === 0
}
