// Finds what the tests in Firefox and WebKit drive, on Linux: elsewhere there is no WebKitGTK.

import { onPath } from './run.mjs'

export const hasOtherBrowsers = process.platform === 'linux'

export function findFirefox() {
  return onPath('firefox-esr', 'firefox')
}

export function findWebKitDriver() {
  return onPath('WebKitWebDriver')
}

/** A screen for both: without one they draw no WebGL. */
export function findXvfb() {
  return onPath('Xvfb')
}
