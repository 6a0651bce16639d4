/** The page Mesh in a browser: a file becomes a sentence, a list, a picture, and any cell is in the lens. */
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Page } from '@playwright/test'
import { headlineOf } from '../../web/mesh/mesh-headline'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { practiceFile } from '../../web/survey/practice'
import { checked, moved } from '../unit/mesh-fixtures'
import { packedVtu } from '../unit/packed-vtu'
import { pvdText, vtuOf } from '../unit/vtu-text'
import { drop } from './input'
import { expect, expectAxeFindsNothing, type Lens, test } from './lens'

const shared = (name: string) => fileURLToPath(new URL(`../../../shared/meshes/${name}`, import.meta.url))

const headline = (page: Page) => page.locator('.overview .headline')
const rows = (page: Page) => page.locator('.list .row:not(.head)')
const which = (page: Page) => page.locator('.one .which')

// Picture, list and lens are beside each other.
test.use({ viewport: { width: 1240, height: 560 } })

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
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2 - 20)
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
    await expect(page.locator('.go .count')).toHaveText(/^\s*All 7,168 cells\s*$/)
  })

  await test.step('keys alone brush the histogram, and a pointer does', async () => {
    const count = page.locator('.go .count')
    const [lower, upper] = ['Least', 'Greatest'].map(end =>
      page.getByRole('slider', { name: `${end} relative minimum in the list` }),
    )
    if (!lower || !upper) throw new Error('There are no ends.')
    await upper.press('Home')
    await expect(upper).toHaveAttribute('aria-valuetext', '−1')
    await expect(count).toHaveText(/^\s*4 of 7,168 cells/)
    await upper.press('End')
    await lower.press('ArrowRight')
    await expect(lower).toHaveAttribute('aria-valuenow', '-1')
    await expect(count).toHaveText(/^\s*7,164 of 7,168 cells/)
    await lower.press('Escape')
    await expect(count).toHaveText(/^\s*All 7,168 cells\s*$/)
    const box = await page.locator('.histogram .plot').boundingBox()
    if (!box) throw new Error('There is no histogram.')
    // The handle of the greatest end is taken to the left; what is listed changes when it is let go.
    await page.mouse.move(box.x + box.width + 6, box.y + box.height / 2)
    await page.mouse.down()
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 2)
    await expect(page.locator('.histogram .range')).toBeVisible()
    await expect(count).toHaveText(/^\s*All 7,168 cells/)
    await page.mouse.up()
    await expect(count).toHaveText(/^\s*\d of 7,168 cells/)
    await page.getByRole('button', { name: 'Whole range' }).click()
    await expect(count).toHaveText(/^\s*All 7,168 cells\s*$/)
  })

  await test.step('it is sorted by a column, and a cell is found by its index', async () => {
    const heading = page.getByRole('columnheader', { name: 'Relative min.' })
    await heading.getByRole('button').click()
    await expect(heading).toHaveAttribute('aria-sort', 'descending')
    await page.getByLabel('Sorted by').selectOption('By who accepts')
    const accepted = page.getByRole('columnheader', { name: 'Accepted by' })
    await expect(accepted).toHaveAttribute('aria-sort', 'ascending')
    await expect(rows(page).first()).toContainText('none')
    await page.getByLabel('Sorted by').selectOption('By volume')
    await expect(heading).toHaveAttribute('aria-sort', 'none')
    await expect(page.getByRole('columnheader', { name: 'Volume' })).toHaveAttribute('aria-sort', 'ascending')
    await page.getByLabel('Go to index').fill('6994')
    await page.getByRole('button', { name: 'Go', exact: true }).click()
    await expect(which(page)).toHaveText(/^Cell 6994/)
    await expect(page.locator('.list .row.chosen')).toContainText('6994')
    await page.getByLabel('Go to index').fill('99999')
    await page.getByRole('button', { name: 'Go', exact: true }).click()
    await expect(page.getByText('There is no cell 99999 in the list.')).toBeVisible()
  })

  await test.step('sets of cells in the picture', async () => {
    const set = page.getByLabel('Cells in the picture')
    for (const name of ['Invalid cells', 'Around the chosen cell', 'Listed cells', 'All cells']) {
      await set.selectOption({ label: name })
      await expect.poll(() => paintedShare(page)).toBeGreaterThan(0.0005)
    }
    await expectAxeFindsNothing(page)
  })
})

test('for each place that the slice is slid to, the mesh is drawn once', async ({ page }) => {
  await page.addInitScript(() => {
    const counted = { pictures: 0 }
    Object.assign(globalThis, { counted })
    const { clear, COLOR_BUFFER_BIT } = WebGL2RenderingContext.prototype
    WebGL2RenderingContext.prototype.clear = function (mask) {
      if (mask & COLOR_BUFFER_BIT) counted.pictures++
      clear.call(this, mask)
    }
  })
  // The lens clears a picture of its own, but not while the slice slides.
  const pictures = () =>
    page.evaluate(() => (globalThis as unknown as { counted: { pictures: number } }).counted.pictures)
  await openMesh(page)
  await page.getByRole('button', { name: 'Slice', exact: true }).click()
  const count = page.locator('.picture .bar .count')
  await expect(count).toHaveText('4,070 of 7,168 cells.')
  await page.waitForTimeout(500)
  const outline = page.locator('.plane .outline')
  for (const place of ['0.3', '0.6', '0.8']) {
    const [before, cells, line] = [await pictures(), await count.textContent(), await outline.getAttribute('d')]
    await page.locator('.bar input[type=range]').fill(place)
    await expect(count).not.toHaveText(cells ?? '')
    await expect(outline).not.toHaveAttribute('d', line ?? '')
    await page.waitForTimeout(300)
    expect((await pictures()) - before).toBe(1)
  }
})

test('the picture: slice, threshold, peel, dig, apart, around a cell, and settings that travel', async ({
  lens,
  page,
}) => {
  await openMesh(page)
  const bar = page.locator('.picture .bar')
  const count = bar.locator('.count')
  const canvas = page.locator('.canvas')
  const toggle = (name: string) => bar.getByRole('button', { name, exact: true })
  // At once: the next frame draws another path.
  const onChosen = () =>
    page.evaluate(() => {
      const box = document.querySelector('.mesh-overlay .chosen')?.getBoundingClientRect()
      if (!box) throw new Error('No cell is chosen.')
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
    })
  await expect(count).toHaveText('7,168 of 7,168 cells.')

  await test.step('a slice across an axis, the other side, and as one looks', async () => {
    await toggle('Slice').click()
    await expect(count).toHaveText('4,070 of 7,168 cells.')
    await bar.getByRole('button', { name: 'Flip' }).click()
    await expect(count).toHaveText('3,098 of 7,168 cells.')
    await expect(bar.getByLabel('Azimuth')).toHaveValue('180')
    await bar.getByRole('button', { name: 'y', exact: true }).click()
    await expect(count).toHaveText('3,584 of 7,168 cells.')
    await bar.getByRole('button', { name: 'As I look' }).click()
    await expect(bar.getByLabel('Azimuth')).toHaveValue('−58')
    await expect(bar.getByLabel('Elevation')).toHaveValue('24')
  })

  await test.step('turned by fields, keys and its handle, slid by keys; what is no number is refused', async () => {
    await bar.getByLabel('Elevation').fill('ninety')
    await bar.getByLabel('Elevation').press('Enter')
    await expect(bar.locator('.complaint')).toContainText('“ninety” is not one number')
    await bar.getByLabel('Elevation').fill('0')
    await bar.getByLabel('Elevation').press('Enter')
    await expect(bar.locator('.complaint')).toHaveCount(0)
    await bar.getByLabel('Azimuth').fill('90')
    await bar.getByLabel('Azimuth').press('Enter')
    await expect(count).toHaveText('3,584 of 7,168 cells.')
    await canvas.press('Shift+ArrowUp')
    await expect(bar.getByLabel('Elevation')).toHaveValue('5')
    await canvas.press('PageDown')
    await expect(count).not.toHaveText('3,584 of 7,168 cells.')
    const before = await count.textContent()
    const tip = await page.locator('.plane .turn .knob').boundingBox()
    if (!tip) throw new Error('The plane has no handle.')
    await page.mouse.move(tip.x + tip.width / 2, tip.y + tip.height / 2)
    await page.mouse.down()
    await page.mouse.move(tip.x + 25, tip.y - 40, { steps: 4 })
    await page.mouse.up()
    await expect(bar.getByLabel('Elevation')).not.toHaveValue('5')
    await expect(count).not.toHaveText(before ?? '')
    await toggle('Slice').click()
    await expect(count).toHaveText('7,168 of 7,168 cells.')
  })

  await test.step('a threshold counts its cells', async () => {
    await toggle('Threshold').click()
    await expect(count).toHaveText('29 of 7,168 cells.')
    const field = bar.getByLabel('Greatest relative minimum', { exact: true })
    await field.fill('1/2')
    await field.press('Enter')
    await expect(field).toHaveValue('0.5')
    await expect(count).toHaveText('48 of 7,168 cells.')
    await bar.getByLabel(/^Relative minimum/).selectOption({ label: 'at least' })
    await expect(count).toHaveText('7,120 of 7,168 cells.')
    await bar.getByLabel('Least relative minimum, slider').press('Home')
    await expect(bar.getByLabel('Least relative minimum', { exact: true })).toHaveValue('−1')
    await toggle('Threshold').click()
  })

  await test.step('layers are peeled off', async () => {
    await toggle('Peel').click()
    await expect(bar.getByText('1 of 10 layers peeled off the boundary')).toBeVisible()
    await expect(count).toHaveText('5,824 of 7,168 cells.')
    await bar.getByLabel('Layers that are peeled off').press('End')
    await expect(count).toHaveText('0 of 7,168 cells.')
    await toggle('Peel').click()
  })

  await test.step('a click digs, what is behind is dug next, and Ctrl+Z takes it back', async () => {
    await toggle('Dig').click()
    const { x, y } = await onChosen()
    await page.mouse.click(x, y)
    await expect(count).toHaveText('7,167 of 7,168 cells.')
    await page.mouse.click(x, y)
    await expect(count).toHaveText('7,166 of 7,168 cells.')
    await page.keyboard.press('Control+z')
    await expect(count).toHaveText('7,167 of 7,168 cells.')
    await canvas.press('Delete')
    await expect(count).toHaveText('7,166 of 7,168 cells.')
    await bar.getByRole('button', { name: 'Undo' }).click()
    await bar.getByRole('button', { name: 'Undo' }).click()
    await expect(count).toHaveText('7,168 of 7,168 cells.')
    await expect(which(page)).toHaveText(/^Cell 2951/)
    await toggle('Dig').click()
  })

  await test.step('cells are pointed at and chosen when they are drawn apart, too', async () => {
    await toggle('Apart').click()
    const { x, y } = await onChosen()
    const tip = page.locator('.picture .tip')
    await page.mouse.move(x, y)
    await expect(tip).toHaveText(/^Cell \d+: (in)?valid$/)
    const id = /\d+/.exec((await tip.textContent()) ?? '')?.[0]
    await page.mouse.click(x, y)
    await expect(which(page)).toHaveText(new RegExp(`^Cell ${id}\\.`))
    await bar.getByRole('button', { name: 'Fly to cell' }).click()
    await canvas.press('f')
    await toggle('Apart').click()
  })

  await test.step('around the chosen cell, which is the next invalid one by N', async () => {
    await page.getByLabel('Cells in the picture').selectOption({ label: 'Around the chosen cell' })
    await expect(count).toHaveText('27 of 7,168 cells.')
    await bar.getByLabel('Rings around').selectOption('0')
    await expect(count).toHaveText('1 of 7,168 cells.')
    await bar.getByLabel('Rings around').selectOption('1')
    await page.locator('.list .rows').press('n')
    await expect(lens.verdict).toHaveText(/^INVALID/)
  })

  await test.step('the settings are in the address, and the same after a reload', async () => {
    await toggle('Slice').click()
    await toggle('Settings').click()
    await bar.getByLabel(/^Colours/).selectOption({ label: 'of invalid cells' })
    await page.getByLabel('Usual conditions').selectOption({ label: 'Invalid' })
    await page.getByLabel('Sorted by').selectOption('By volume')
    await expect.poll(() => page.url()).toContain('sort=volume')
    const [address, cell, cells] = [page.url(), await which(page).textContent(), await count.textContent()]
    expect(address).toContain('cells=around&rings=1&slice=')
    await expectAxeFindsNothing(page)
    await page.reload()
    await expect(count).toHaveText(cells ?? '')
    await expect(which(page)).toHaveText(cell ?? '')
    await expect(page.locator('.go .count')).toHaveText(/^\s*12 of 7,168 cells/)
    await expect(page.getByLabel('Sorted by')).toHaveValue('volume')
    await expect.poll(() => page.url()).toBe(address)
  })

  await test.step('they go into another mesh, which says what does not fit', async () => {
    await toggle('Settings').click()
    const text = await bar.getByLabel('All settings').inputValue()
    await openFiles(page, 'real/rockerarm.mesh')
    await expect(headline(page)).toHaveText('All 10,600 hexahedra are valid.')
    await expect(count).toHaveText('10,600 of 10,600 cells.')
    await expect.poll(() => page.url()).not.toContain('slice')
    const field = bar.getByLabel('All settings')
    await field.fill('picture=1&of=1&peel=much')
    await field.press('Enter')
    await expect(bar.locator('.notice')).toHaveText('The setting peel=much should be a number of layers.')
    await field.fill(text)
    await bar.getByRole('button', { name: 'Use' }).click()
    await expect(bar.locator('.notice')).toHaveText(
      'Single cells are left out (the chosen one): the settings are of a mesh of 7,168 hexahedra.',
    )
    await expect(toggle('Slice')).toHaveAttribute('aria-pressed', 'true')
    await expect(page.locator('.go .count')).toHaveText(/^\s*0 of 10,600 cells/)
    await expect.poll(() => page.url()).toContain('picture=1&of=10600&cells=around')
  })

  await test.step('an address of a mesh that is not open waits for it', async () => {
    await page.goto('about:blank')
    await page.goto('mesh.html#picture=1&of=10600&relative=..0.4')
    await expect(bar.locator('.notice')).toHaveText(
      'The address has settings of a mesh of 10,600 hexahedra: open it, and they are used.',
    )
    await openFiles(page, 'real/rockerarm.mesh')
    await expect(count).toHaveText('13 of 10,600 cells.')
  })

  await test.step('into one of another size it does not go unasked', async () => {
    await page.goto('about:blank')
    await page.goto('mesh.html#picture=1&of=603&list=volume%3C0&sort=volume')
    await openFiles(page, 'real/rockerarm.mesh')
    await expect(bar.locator('.notice')).toHaveText(
      'The address had settings of a mesh of 603 hexahedra; this one has 10,600, so they are not used.',
    )
    await expect(page.locator('.go .count')).toHaveText(/^\s*All 10,600 cells/)
    await expect.poll(() => page.url()).not.toContain('#')
  })
})

test('files: mirrored cells by one click, a second mesh, what cannot be read', async ({ lens, page }) => {
  await openMesh(page)
  await openFiles(page, 'real/matrix_fiber_rand.vtk')
  await expect(headline(page)).toHaveText(/^97 of 603 hexahedra are invalid/)
  const bar = page.locator('.picture .bar')
  const drawn = bar.locator('.count')
  for (const [set, count] of [
    ['all', '603 of 603 cells.'],
    ['around', /^(?!603)\d+ of 603 cells\.$/],
    ['listed', '603 of 603 cells.'],
    ['block-1', /^(?!603)\d+ of 603 cells\.$/],
  ] as const)
    await test.step(`${set} is what it says, and what its own settings say`, async () => {
      await bar.getByLabel('Cells in the picture').selectOption(set)
      await expect(drawn).toHaveText(count)
      const [cells, address] = [await drawn.textContent(), bar.getByLabel('All settings')]
      await bar.getByRole('button', { name: 'Settings' }).click()
      await address.press('Enter')
      await expect(bar.locator('.notice')).toHaveText('These settings are used now.')
      await expect(drawn).toHaveText(cells ?? '')
      await bar.getByRole('button', { name: 'Settings' }).click()
    })
  await bar.getByLabel('Cells in the picture').selectOption('all')
  await page.getByRole('button', { name: 'Correct 97 mirrored cells' }).click()
  await expect(headline(page)).toHaveText('All 603 hexahedra are valid.')
  await expect(drawn).toHaveText('603 of 603 cells.')
  await expect(page.locator('.notes')).toContainText('97 mirrored hexahedra have been corrected here')
  await expect(page.locator('.notes li').filter({ hasText: 'Coordinates are printed' })).toContainText(
    'write more digits, or doubles.',
  )

  await test.step('where no invalid cell is listed, the key for the next says so', async () => {
    await page.locator('.list .rows').press('n')
    await expect(page.locator('p.message')).toHaveText('No invalid cell is in the list.')
  })

  await test.step('a condition that is refused leaves the list, and says so', async () => {
    await page.locator('#condition').fill('volume >')
    await page.locator('#condition').press('Enter')
    await expect(page.locator('#condition-complaint')).toHaveText(/ The list is as it was\.$/)
    await expect(page.locator('.go .count')).toHaveText(/^\s*All 603 cells\s*$/)
    await page.locator('#condition').fill('')
    await page.locator('#condition').press('Enter')
    await expect(page.locator('#condition-complaint')).toBeEmpty()
  })

  await openFiles(page, 'made/vtk-raw-none.vtu')
  await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  const before = await chosenIn(lens)

  await page.locator('.overview input[type=file]').setInputFiles({
    name: 'letter.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from('Dear mesh, how are you?'),
  })
  await expect(page.locator('.news')).toContainText('letter.txt')
  await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  expect(await chosenIn(lens)).toEqual(before)
})

test('a large file is read by several workers as it comes, and by blocks', async ({ page }) => {
  const raw = Buffer.from(await practiceFile(0.6).arrayBuffer())
  const [mesh] = readMeshes(fileOfBytes('raw.vtu', Uint8Array.from(raw)))
  if (!mesh) throw new Error('There is no mesh.')
  const check = await checked(mesh, { worst: 3, lists: { acceptedBy: true } })
  const inline = packedVtu(mesh, 'inline')
  await openMesh(page)
  const open = (name: string, buffer: Buffer) =>
    page.locator('.overview input[type=file]').setInputFiles({ name, mimeType: '', buffer })
  for (const [name, bytes] of [
    ['raw.vtu', raw],
    ['inline.vtu', inline],
    ['appended.vtu', packedVtu(mesh, 'appended')],
  ] as const) {
    await open(name, bytes)
    await expect(page.locator('.notes')).toContainText(name)
    await expect(headline(page)).toHaveText(headlineOf(check))
    for (const [i, cell] of check.worst.entries()) await expect(rows(page).nth(i)).toContainText(String(cell))
  }
  const damaged = Buffer.from(inline)
  const middle = damaged.length >> 1
  damaged.fill('A', middle, middle + 99)
  await open('damaged.vtu', damaged)
  await expect(page.locator('.news')).toContainText(/damaged\.vtu, byte \d+: “Points”/)
  await expect(headline(page)).toHaveText(headlineOf(check))
})

test('a long id is seen whole in the list', async ({ page }) => {
  await openMesh(page)
  const nodes = ['0,0,0', '1,0,0', '1,1,0', '0,1,0', '0,0,1', '1,0,1', '1,1,1', '0,1,1'].map(
    (at, i) => `${i + 1},${at}`,
  )
  const text = ['*NODE', ...nodes, '*ELEMENT,TYPE=C3D8', '1234567890,1,2,3,4,5,6,7,8', ''].join('\n')
  const file = { name: 'long.inp', mimeType: '', buffer: Buffer.from(text) }
  await page.locator('.overview input[type=file]').setInputFiles(file)
  const id = rows(page).first().locator('.id')
  await expect(id).toHaveText('1234567890')
  expect(await id.evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth)).toBe(true)
})

test('from the lens a list goes along, whatever it was read from; nothing of it is left behind', async ({
  lens,
  page,
}) => {
  await lens.open()
  await drop(lens.scene, { files: [{ name: 'a.vtu', bytes: readFileSync(shared('made/vtk-raw-none.vtu')) }] })
  const way = page.getByRole('button', { name: 'Open all 16 cells on the page Mesh' })
  await expect(way).toBeVisible()
  await expectAxeFindsNothing(page)
  await way.click()
  await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  await expect(page.locator('.notes')).toContainText('a.vtu, VTU.')
  const handed = () =>
    page.evaluate(
      () =>
        new Promise<number>((resolve, reject) => {
          const opening = indexedDB.open('hexlens-handed', 1)
          opening.onerror = reject
          opening.onsuccess = () => {
            const count = opening.result.transaction('lists').objectStore('lists').count()
            count.onsuccess = () => resolve(count.result)
          }
        }),
    )
  expect(await handed()).toBe(0)

  await test.step('where the browser keeps nothing, a sentence says where to drop it', async () => {
    await page.goto('./')
    await page.evaluate(() => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('no', 'SecurityError')
      }
    })
    await drop(lens.scene, { files: [{ name: 'b.vtu', bytes: readFileSync(shared('made/vtk-raw-zlib.vtu')) }] })
    await way.click()
    await expect(page.locator('.to-mesh')).toContainText('drop it on the page Mesh')
  })
})

test('cancelled in the middle, what was open stays; keys alone lead from there to lens and files', async ({
  lens,
  page,
}) => {
  // The worker of the next mesh is slow to answer: whoever cancels is sooner.
  await page.addInitScript(() => {
    Object.assign(globalThis, { held: false })
    const { postMessage } = Worker.prototype
    Worker.prototype.postMessage = function (this: Worker, ...given: unknown[]) {
      const { held } = globalThis as unknown as { held: boolean }
      if (!held || (given[0] as { kind: string }).kind !== 'open') Reflect.apply(postMessage, this, given)
    }
  })
  await openMesh(page)
  await expect(page.locator('.histogram svg')).toBeVisible()
  const hold = (held: boolean) => page.evaluate(value => Object.assign(globalThis, { held: value }), held)
  await hold(true)
  await openFiles(page, 'real/rockerarm.mesh')
  const cancel = page.getByRole('button', { name: 'Cancel' })
  await expect(cancel).toBeVisible()
  await expectAxeFindsNothing(page)
  await cancel.press('Enter')
  await expect(page.locator('.news')).toHaveText('Cancelled. What is below is still the example.')
  await expect(page.getByRole('button', { name: 'Open files' })).toBeFocused()
  await hold(false)

  const list = page.getByRole('grid', { name: 'Cells' })
  await list.focus()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await expect(which(page)).toHaveText(/^Cell 2547/)
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await expect(list).toBeFocused()

  await test.step('headings sort by their own keys', async () => {
    await page.keyboard.press('Tab')
    await expect(page.getByRole('columnheader', { name: 'Cell' }).getByRole('button')).toBeFocused()
    await page.keyboard.press('Enter')
    await expect(page.getByRole('columnheader', { name: 'Cell' })).toHaveAttribute('aria-sort', 'ascending')
    await expect(which(page)).toHaveText(/^Cell 2547/)
  })

  await test.step('rows and columns are counted, and cells say which they are', async () => {
    await expect(list).toHaveAttribute('aria-rowcount', '7169')
    await expect(list).toHaveAttribute('aria-colcount', '6')
    await expect(rows(page).first().getByRole('gridcell').last()).toHaveAttribute('aria-colindex', '6')
  })

  await test.step('the menu of files, and a file', async () => {
    const menu = page.getByRole('button', { name: 'Take away' })
    await menu.press('Enter')
    const download = page.waitForEvent('download')
    await page.getByRole('button', { name: /^List / }).press('Enter')
    expect((await download).suggestedFilename()).toMatch(/-invalid-ids\.txt$/)
    await expectAxeFindsNothing(page)
    await page.keyboard.press('Escape')
    await expect(menu).toBeFocused()
  })
})

test('a folder of steps with equal names, and a .pvd of them', async ({ page }) => {
  await openMesh(page)
  const folder = mkdtempSync(join(tmpdir(), 'hexlens-steps-'))
  for (const [step, z] of [1, 0.5, -1].entries()) {
    mkdirSync(join(folder, `t${step}`))
    writeFileSync(join(folder, `t${step}`, 'w.vtu'), vtuOf([moved(6, [1, 1, z])]))
  }
  const choose = async () => {
    const chooser = page.waitForEvent('filechooser')
    await page.getByRole('button', { name: 'Open a folder' }).click()
    await (await chooser).setFiles(folder)
  }
  await choose()
  await expect(page.getByText('3 files are taken as 3 steps of one mesh')).toBeVisible()
  await expect(page.locator('.steps [role=status]')).toContainText('is the first with an invalid cell')
  const slider = page.getByRole('slider', { name: 'Time step' })
  await slider.focus()
  await page.keyboard.press('End')
  await expect(headline(page)).toHaveText(/^The hexahedron is invalid/)
  await expect(slider).toBeFocused()
  await expectAxeFindsNothing(page)

  const sets = ['0', '1', '2'].map(time => ({ time: `0.${time}`, file: `t${time}/w.vtu` }))
  writeFileSync(join(folder, 'case.pvd'), pvdText(sets))
  await choose()
  await expect(page.getByText('case.pvd has 3 time steps of one mesh.')).toBeVisible()
  await expect(page.locator('.steps .now')).toContainText('t = 0.0')
  rmSync(folder, { recursive: true })
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
    await expect(page.locator('.picture .bar')).toBeHidden()
    // Below the window the lens has no views yet.
    await expectAxeFindsNothing(page)
    await rows(page).nth(1).click()
    await expect(which(page)).toHaveText(/^Cell 2547/)
    // The lens is below the list, and comes into the window with the cell that was chosen for it.
    await expect(page.locator('hex-lens')).toBeInViewport({ ratio: 0.9 })
    await expect(page.locator('hex-lens')).toHaveJSProperty('complete', true)
    await expect(page.locator('hex-lens .verdict .word')).toHaveText('INVALID')
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390)
    await expectAxeFindsNothing(page)
  })
})
