/** The page Mesh in a browser: a file becomes a sentence, a list, a picture, and any cell is in the lens. */
import { fileURLToPath } from 'node:url'
import type { Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, type Lens, test } from './lens'

const shared = (name: string) => fileURLToPath(new URL(`../../../shared/meshes/${name}`, import.meta.url))

const headline = (page: Page) => page.locator('.overview .headline')
const rows = (page: Page) => page.locator('.list .row:not(.head)')
const which = (page: Page) => page.locator('.one .which')

async function openMesh(page: Page): Promise<void> {
  await page.goto('mesh.html')
  await expect(headline(page)).toHaveText(/^12 of 7,168 hexahedra are invalid/)
}

async function openFiles(page: Page, ...names: string[]): Promise<void> {
  await page.locator('.overview input[type=file]').setInputFiles(names.map(shared))
}

/** The share of the picture that is not the paper, as it is on the screen. */
async function paintedShare(page: Page): Promise<number> {
  const png = (await page.locator('.canvas').screenshot()).toString('base64')
  return page.evaluate(async data => {
    const picture = new Image()
    picture.src = `data:image/png;base64,${data}`
    await picture.decode()
    const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d')
    if (!context) throw new Error('There is no canvas.')
    context.drawImage(picture, 0, 0)
    const pixels = new Uint32Array(context.getImageData(0, 0, picture.width, picture.height).data.buffer)
    return pixels.filter(pixel => pixel !== pixels[0]).length / pixels.length
  }, png)
}

async function chosenIn(lens: Lens): Promise<number[]> {
  await lens.nextFrame()
  return lens.vertices()
}

test('the first mesh: sentence, list, filter, picture, lens', async ({ lens, page }) => {
  await openMesh(page)
  await test.step('the worst cell is in the lens, and first in the list', async () => {
    await expect(rows(page).first()).toContainText('−2.2606')
    await expect(rows(page).first()).toHaveAttribute('aria-selected', 'true')
    await expect(which(page)).toHaveText(/^Cell 2951/)
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(page.locator('.histogram svg')).toHaveAttribute('aria-label', /from −2\.26.* to 1/)
  })

  await test.step('the picture is there, and a click in it chooses a cell', async () => {
    await expect(page.locator('.bar select').first()).toBeVisible()
    await expect.poll(() => paintedShare(page)).toBeGreaterThan(0.1)
    const before = await chosenIn(lens)
    const box = await page.locator('.canvas').boundingBox()
    if (!box) throw new Error('There is no picture.')
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2 - 40)
    await expect.poll(() => chosenIn(lens)).not.toEqual(before)
    await expect(page.locator('.list .row.chosen')).toHaveCount(1)
  })

  await test.step('keys and buttons go through the invalid cells', async () => {
    await page.locator('.list .rows').press('n')
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await page.getByRole('button', { name: 'Next' }).click()
    await expect(lens.verdict).toHaveText(/^INVALID/)
  })

  await test.step('a condition lists what meets it; what is none is refused', async () => {
    await page.getByLabel('Usual conditions').selectOption({ label: 'Invalid, yet the corners accept' })
    await expect(page.locator('.go .count')).toHaveText(/^\s*4 of 7,168 cells\s*$/)
    await expect(rows(page)).toHaveCount(4)
    const own = page.locator('#condition')
    await own.fill('corner_min >')
    await own.press('Enter')
    await expect(page.locator('#condition-complaint')).not.toBeEmpty()
    await expect(own).toHaveValue('corner_min >')
    await own.fill('')
    await own.press('Enter')
    await expect(page.locator('.go .count')).toHaveText(/7,168 of 7,168/)
  })

  await test.step('it is sorted by a column, and a cell is found by its index', async () => {
    await page.getByRole('columnheader', { name: 'Volume' }).getByRole('button').click()
    await expect(page.getByRole('columnheader', { name: 'Volume' })).toHaveAttribute('aria-sort', 'ascending')
    await page.getByLabel('Go to index').fill('6994')
    await page.getByRole('button', { name: 'Go', exact: true }).click()
    await expect(which(page)).toHaveText(/^Cell 6994/)
    await expect(page.locator('.list .row.chosen')).toContainText('6994')
    await page.getByLabel('Go to index').fill('99999')
    await page.getByRole('button', { name: 'Go', exact: true }).click()
    await expect(page.getByText('There is no cell 99999 in the list.')).toBeVisible()
  })

  await test.step('modes of the picture', async () => {
    const mode = page.getByLabel('Cells in the picture')
    for (const name of ['Slice', 'Invalid cells', 'Listed cells', 'Surface']) {
      await mode.selectOption({ label: name })
      await expect.poll(() => paintedShare(page)).toBeGreaterThan(0.0005)
    }
    await expectAxeFindsNothing(page)
  })
})

test('files: mirrored cells by one click, a second mesh, what cannot be read', async ({ lens, page }) => {
  await openMesh(page)
  await openFiles(page, 'real/matrix_fiber_rand.vtk')
  await expect(headline(page)).toHaveText(/^97 of 603 hexahedra are invalid/)
  await page.getByRole('button', { name: 'Correct 97 mirrored cells' }).click()
  await expect(headline(page)).toHaveText('All 603 hexahedra are valid.')
  await expect(page.locator('.notes')).toContainText('97 mirrored hexahedra have been corrected here')

  await openFiles(page, 'made/vtk-raw-none.vtu')
  await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  const before = await chosenIn(lens)

  await page.locator('.overview input[type=file]').setInputFiles({
    name: 'letter.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from('Dear mesh, how are you?'),
  })
  await expect(page.locator('.refused')).toContainText('letter.txt')
  await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  expect(await chosenIn(lens)).toEqual(before)
})

test.describe('without WebGL', () => {
  test('sentence, list and lens say all the same, on a phone', async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 844 })
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
        apply: (target, self, args) => (String(args[0]).startsWith('webgl') ? null : Reflect.apply(target, self, args)),
      })
      const { OffscreenCanvas } = globalThis
      OffscreenCanvas.prototype.getContext = new Proxy(OffscreenCanvas.prototype.getContext, {
        apply: (target, self, args) => (String(args[0]).startsWith('webgl') ? null : Reflect.apply(target, self, args)),
      })
    })
    await openMesh(page)
    await expect(page.locator('.is-not-drawn')).toBeVisible()
    await rows(page).nth(1).click()
    await expect(which(page)).toHaveText(/^Cell 2547/)
    await expect(page.locator('hex-lens .verdict .word')).toHaveText('INVALID')
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390)
    await expectAxeFindsNothing(page)
  })
})
