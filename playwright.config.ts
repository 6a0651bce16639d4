import { defineConfig } from '@playwright/test'
import { hasOtherBrowsers } from './tools/browsers.mjs'
import { findChromium } from './tools/chromium.mjs'

const port = Number(process.env.HEXLENS_TEST_PORT ?? 41735)
const results = process.env.HEXLENS_TEST_RESULTS ?? 'test-results/browser'
const executablePath = await findChromium()

export default defineConfig({
  testMatch: '**/*.spec.ts',
  projects: [
    { name: 'pack', testDir: 'tests/package', testMatch: '*.setup.ts' },
    { name: 'chromium', testDir: 'tests/e2e' },
    { name: 'package', testDir: 'tests/package', dependencies: ['pack'] },
    ...(hasOtherBrowsers ? ['firefox', 'webkit'].map(name => ({ name, testDir: 'tests/browsers' })) : []),
  ],
  outputDir: `${results}/playwright`,
  reporter: [['list'], ['json', { outputFile: `${results}/browser.json` }]],
  // More than the cores: a page that waits leaves one idle.
  workers: 3,
  retries: 0,
  forbidOnly: true,
  // Guards against hanging, not measurements: machines may be slow and busy.
  timeout: 300_000,
  expect: { timeout: 30_000 },
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: { width: 900, height: 480 },
    screenshot: 'only-on-failure',
    launchOptions: {
      ...(executablePath ? { executablePath } : {}),
      args: [
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
      ],
    },
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
