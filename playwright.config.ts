import { fileURLToPath } from 'node:url'
import { defineConfig } from '@playwright/test'
import { hasOtherBrowsers } from './tools/browsers.mjs'
import { findChromium } from './tools/chromium.mjs'

const port = Number(process.env.HEXLENS_TEST_PORT ?? 41735)
const results = process.env.HEXLENS_TEST_RESULTS ?? 'test-results/browser'
const executablePath = await findChromium()
const args = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  // WebGL is drawn by the software GPU; the rest of the page, which Debian has it draw too, is cheaper without it.
  '--disable-gpu-compositing',
  '--disable-gpu-rasterization',
]
const chromium = executablePath ? { executablePath, args } : { args }

/** A page looks the same on every machine: its fonts are named, and neither hinting nor a screen's stripes nor the port change it. */
const SAME_HOST = 'hexlens.localhost'
const sameEverywhere = {
  ...chromium,
  args: [
    ...args,
    '--font-render-hinting=none',
    '--disable-lcd-text',
    `--host-resolver-rules=MAP ${SAME_HOST}:80 127.0.0.1:${port}`,
  ],
  env: { ...process.env, FONTCONFIG_FILE: fileURLToPath(new URL('tests/visual/fonts.conf', import.meta.url)) },
}

export default defineConfig({
  testMatch: '**/*.spec.ts',
  // The longest first, so that no worker is left with it in the end.
  projects: [
    { name: 'pack', testDir: 'tests/package', testMatch: 'pack.spec.ts' },
    ...(hasOtherBrowsers ? ['firefox', 'webkit'].map(name => ({ name, testDir: 'tests/browsers' })) : []),
    ...(hasOtherBrowsers
      ? [
          {
            name: 'visual',
            testDir: 'tests/visual',
            use: { baseURL: `http://${SAME_HOST}/`, launchOptions: sameEverywhere },
          },
        ]
      : []),
    { name: 'chromium', testDir: 'tests/e2e', fullyParallel: true },
    { name: 'package', testDir: 'tests/package', testIgnore: 'pack.spec.ts' },
  ],
  outputDir: `${results}/playwright`,
  reporter: [['list'], ['json', { outputFile: `${results}/browser.json` }]],
  // More than the cores: a page that waits leaves one idle.
  workers: 3,
  retries: 0,
  forbidOnly: true,
  // Guards against hanging, not measurements: machines may be slow and busy.
  timeout: 300_000,
  expect: {
    timeout: 30_000,
    // Another processor rounds shades differently at a few pixels.
    toHaveScreenshot: { maxDiffPixelRatio: 0.002, pathTemplate: 'tests/visual/snapshots/{arg}{ext}' },
  },
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: { width: 900, height: 480 },
    screenshot: 'only-on-failure',
    launchOptions: chromium,
  },
  webServer: {
    command: `node tools/start.mjs --port ${port} --out dist/test-${port}`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
    timeout: 120_000,
    stdout: 'ignore',
    stderr: 'pipe',
  },
})
