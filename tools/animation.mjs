// npm run animation: drags a vertex of the real page, takes a picture of each step, and writes docs/drag.webp from them; and
// docs/mesh.webp, the page Mesh as it begins.

import { mkdtempSync, rmSync, statSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { buildPage, viteConfig } from './build.mjs'
import { findChromium } from './chromium.mjs'
import { Failure, must, onPath, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const FOLDER = 'dist/animation'
const SIZE = { width: 720, height: 460 }
/** The page Mesh has its three columns. */
const MESH_SIZE = { width: 1360, height: 820 }
const STEPS = 22
const FRAME_MS = 70
/** Milliseconds for which the ends of the drag are seen. */
const REST_MS = 1200
/** Vertex 6 goes this far, as a part of its way to vertex 4 on the screen. */
const DEPTH = 0.72
const CUBE = '0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 1, 0 1 1'

await runMain(async () => {
  await setup({ purpose: 'test' })
  const img2webp = onPath('img2webp')
  if (!img2webp) throw new Failure('The animation is put together by img2webp: install the package webp, then repeat.')
  await buildPage(FOLDER)
  const frames = mkdtempSync(join(tmpdir(), 'hexlens-animation-'))
  try {
    const [pictures, mesh] = await served(address =>
      inBrowser(async browser => [await drag(browser, address, frames), await meshPage(browser, address, frames)]),
    )
    await write(img2webp, 'drag.webp', pictures)
    await write(img2webp, 'mesh.webp', [mesh])
  } finally {
    rmSync(frames, { recursive: true, force: true })
    rmSync(join(root, FOLDER), { recursive: true, force: true })
  }
})

async function served(work) {
  const { preview } = await import('vite')
  const server = await preview({
    configFile: viteConfig,
    logLevel: 'warn',
    build: { outDir: join(root, FOLDER) },
    preview: { host: '127.0.0.1' },
  })
  try {
    return await work(server.resolvedUrls.local[0])
  } finally {
    await server.close()
  }
}

async function write(img2webp, name, pictures) {
  const target = join(root, 'docs', name)
  const parts = pictures.flatMap(({ file, duration }) => ['-d', String(duration), file])
  await must(img2webp, ['-loop', '0', '-lossy', '-q', '92', '-m', '4', ...parts, '-o', target])
  const kilobytes = Math.round(statSync(target).size / 1000)
  process.stdout.write(`docs/${name}: ${pictures.length} pictures, ${kilobytes} kB\n`)
}

async function inBrowser(work) {
  const { chromium } = await import('@playwright/test')
  const args = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
  const browser = await chromium.launch({ executablePath: await findChromium(), args })
  try {
    return await work(browser)
  } finally {
    await browser.close()
  }
}

/** Neighbours of the chosen cell are drawn last. */
async function meshPage(browser, address, folder) {
  const page = await browser.newPage({ viewport: MESH_SIZE, colorScheme: 'light' })
  await page.goto(`${address}mesh.html`)
  await page.waitForSelector('.mesh-overlay .neighbour', { state: 'attached' })
  await page.waitForFunction(() => document.querySelector('hex-lens').complete)
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))))
  const file = join(folder, 'mesh.png')
  await page.screenshot({ path: file })
  return { file, duration: REST_MS }
}

/** A picture for each step there and back; resolves to files and the milliseconds of each. */
async function drag(browser, address, folder) {
  const page = await browser.newPage({ viewport: SIZE, colorScheme: 'light' })
  await page.goto(`${address}embed.html?views=scene+verdict&controls=none`)
  const lens = page.locator('hex-lens')
  await lens.evaluate((element, vertices) => {
    element.vertices = vertices
    element.style.height = '100vh'
  }, CUBE)
  await page.waitForFunction(() => document.querySelector('hex-lens').complete)
  const placeOf = async vertex => {
    const { x, y, width, height } = await page
      .locator('hex-lens .handle', { hasText: String(vertex) })
      .locator('.dot')
      .boundingBox()
    return { x: x + width / 2, y: y + height / 2 }
  }
  const [from, to] = [await placeOf(6), await placeOf(4)]
  const pictures = []
  const take = async duration => {
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))))
    const file = join(folder, `${String(pictures.length).padStart(3, '0')}.png`)
    await page.screenshot({ path: file })
    pictures.push({ file, duration })
  }
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  for (let i = 0; i <= 2 * STEPS; ++i) {
    const part = (DEPTH * (1 - Math.cos((Math.PI * i) / STEPS))) / 2
    await page.mouse.move(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y))
    await take(i % STEPS === 0 ? REST_MS : FRAME_MS)
  }
  await page.mouse.up()
  return pictures
}
