import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { verticesOf } from '../../web/mesh/vertices-of'
import { drop, pasteAnywhere } from './input'
import {
  expect,
  expectAxeFindsNothing,
  expectLargeTargets,
  expectNoSidewaysOverflow,
  inSchemesAndWidths,
  test,
} from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const upper = cube.map((value, i) => (i % 3 === 2 ? value + 1 : value))
const list = JSON.stringify([
  { name: 'lower', vertices: cube },
  { name: 'upper', vertices: upper },
])

const readRegion = (page: Page) => page.getByRole('region', { name: 'What was read' })
const panelOf = (page: Page, name: string) => page.getByRole('region', { name, exact: true })

async function downloaded(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const download = page.waitForEvent('download')
  await page.getByRole('button', { name: button, exact: true }).click()
  const file = await download
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) }
}

test.beforeEach(({ context }) => context.grantPermissions(['clipboard-read', 'clipboard-write']))

test.describe('paste', () => {
  test('Ctrl+V makes what has eight points the element, as one step to undo, and no panel opens', async ({
    lens,
    page,
  }) => {
    await lens.open()
    const before = await lens.bits()
    await pasteAnywhere(page, `array([[${cube.join(', ')}]])`)
    await expect(readRegion(page)).toContainText('Read as NumPy')
    expect(await lens.vertices()).toEqual(cube)
    await expect(lens.verdict).toHaveText(/^VALID/)
    await expect(page.getByRole('button', { name: 'Paste or drop' })).toHaveAttribute('aria-expanded', 'false')
    await lens.button('Undo').click()
    expect(await lens.bits()).toEqual(before)
    await expect(lens.button('Undo')).toBeDisabled()
    await expect(readRegion(page).getByText('Read as NumPy')).toHaveCount(0)
    await lens.button('Redo').click()
    await expect(readRegion(page)).toContainText('Read as NumPy')
    await lens.field(0, 'x').fill('0.25')
    await lens.field(0, 'x').press('Enter')
    await lens.button('Reset').click()
    expect(await lens.vertices()).toEqual(cube)
  })

  test('from the clipboard, of several elements, from a box, a file or a drop', async ({ lens, page }) => {
    await lens.open()
    const refusal = page.getByRole('alert')

    await test.step('where nothing is found, it says what was seen, and nothing changes', async () => {
      const before = await lens.bits()
      await pasteAnywhere(page, cube.slice(1).join(' '))
      await expect(refusal).toContainText('23 numbers were found; an element needs 24. The element is as it was.')
      await expect(refusal.getByText('23 numbers')).toBeInViewport()
      await pasteAnywhere(page, cube.join(' ').replace('1', '1e999'))
      await expect(refusal).toContainText('vertex 1 x is Infinity')
      await expect(refusal).not.toContainText('23 numbers')
      expect(await lens.bits()).toEqual(before)
      await expect(lens.button('Undo')).toBeDisabled()
    })

    await test.step('with the focus in the element too, but not in a text field of it', async () => {
      await lens.scene.focus()
      await pasteAnywhere(page, cube.join(' '))
      await expect.poll(() => lens.vertices()).toEqual(cube)
      await expect(refusal.getByText('Infinity')).toHaveCount(0)
      await lens.field(0, 'x').focus()
      await pasteAnywhere(page, upper.join(' '))
      await expect(page.getByText(/^Vertex 0 x: “.*” is not one number/)).toBeVisible()
      expect(await lens.vertices()).toEqual(cube)
    })

    await test.step('of several elements one is chosen, by keyboard alone', async () => {
      await lens.scene.focus()
      const before = await lens.bits()
      await pasteAnywhere(page, list)
      const choice = page.getByRole('listbox', { name: 'Cells, worst first' })
      await expect(choice).toBeFocused()
      await expect(choice.getByRole('option')).toHaveCount(2)
      await expect(readRegion(page)).toContainText('2 hexahedra, all VALID. Read as JSON. Choose one to look at it.')
      expect(await lens.bits()).toEqual(before)
      await page.keyboard.press('ArrowDown')
      await page.keyboard.press('Enter')
      await expect(choice.getByRole('option', { name: /^Cell upper, valid, relative minimum 1$/ })).toHaveAttribute(
        'aria-selected',
        'true',
      )
      expect(await lens.vertices()).toEqual(upper)
      await lens.button('Undo').click()
      expect(await lens.bits()).toEqual(before)
      await expect(choice.getByRole('option', { selected: true })).toHaveCount(0)
    })

    await test.step('the box, a file, and the promise that nothing leaves', async () => {
      await lens.button('Paste or drop').click()
      const panel = panelOf(page, 'Paste or drop')
      await expect(panel).toContainText('Nothing that is pasted, dropped or typed here leaves the browser.')
      await expect(panel).toContainText(/Hexlens reads .*Abaqus/)
      await panel.getByRole('textbox', { name: 'Text with eight points' }).fill(cube.map(x => `${x}.0D+00`).join('\n'))
      await lens.button('Read it').click()
      await expect.poll(() => lens.vertices()).toEqual(cube)
      const chooser = page.waitForEvent('filechooser')
      await lens.button('Open files').click()
      await (await chooser).setFiles({
        name: 'a.json',
        mimeType: 'application/json',
        buffer: Buffer.from(JSON.stringify(upper)),
      })
      await expect.poll(() => lens.vertices()).toEqual(upper)
      await expect(panel).toContainText('Read as JSON')
    })

    await test.step('a text that is dropped on the element', async () => {
      await drop(lens.scene, { text: cube.join(' ') })
      await expect.poll(() => lens.vertices()).toEqual(cube)
    })
  })

  test('in a page around the element a paste elsewhere is that page’s', async ({ lens, page }) => {
    await lens.open()
    const before = await lens.bits()
    await page.evaluate(() => {
      const own = document.createElement('button')
      own.textContent = 'Elsewhere'
      document.body.prepend(own)
      own.focus()
    })
    await pasteAnywhere(page, cube.join(' '))
    await lens.nextFrame()
    expect(await lens.bits()).toEqual(before)
    await expect(readRegion(page).getByText(/Read/)).toHaveCount(0)
  })
})

test.describe('take away', () => {
  /** Signs of zero and a subnormal: what a sloppy round trip loses. */
  const hard = cube.with(0, -0).with(4, 5e-324).with(8, 0.1).with(12, -0)

  test('a PNG and texts restore the element bit for bit', async ({ lens, page }) => {
    await lens.open()

    await test.step('a PNG that is dropped again restores the element bit for bit', async () => {
      await lens.set(hard)
      const before = await lens.bits()
      await lens.button('Take away').click()
      const { name, bytes } = await downloaded(page, 'Download PNG')
      expect(name).toBe('hexahedron.png')
      expect(await blueShare(page, bytes)).toBeGreaterThan(0.02)
      await lens.set(upper)
      await drop(lens.scene, { files: [{ name, bytes }] })
      await expect(readRegion(page)).toContainText('Read as a picture from here.')
      expect(await lens.bits()).toEqual(before)
    })

    await test.step('texts are copied and saved alike, and read back bit for bit', async () => {
      await lens.set(hard)
      const before = await lens.vertices()
      for (const [title, file] of [
        ['Report', 'hexahedron.json'],
        ['Python', 'hexahedron.py'],
        ['C', 'hexahedron.c'],
        ['VTK', 'hexahedron.vtk'],
        ['OBJ', 'hexahedron.obj'],
      ] as const) {
        await lens.button(`Copy ${title}`).click()
        await expect(lens.button(`Copied ${title}`)).toBeVisible()
        const copied = await page.evaluate(() => navigator.clipboard.readText())
        const saved = await downloaded(page, `Download ${title}`)
        expect(saved.name).toBe(file)
        expect(saved.bytes.toString('utf8')).toBe(copied)
        expect(readPasted(copied)).toEqual(before)
      }
      await lens.button('Copy BibTeX').click()
      await expect(lens.button('Copied BibTeX')).toBeVisible()
      expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(
        'title = {Validating Hexahedra through their Boundaries}',
      )
      const extremes = await lens.element.evaluate(element => {
        const report = (element as HTMLElementTagNameMap['hex-lens']).report
        return { Minimum: report?.boundaryMinimum, Maximum: report?.boundaryMaximum }
      })
      for (const [title, value] of Object.entries(extremes)) {
        await lens.button(`Copy ${title}`).click()
        await expect(lens.button(`Copied ${title}`)).toBeVisible()
        expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(String(value))
      }
      await lens.button('Copy Link').click()
      await expect(lens.button('Copied Link')).toBeVisible()
      expect(await page.evaluate(() => navigator.clipboard.readText())).toContain('#v=1&vertices=-0,0,0,1,5e-324,')
    })
  })

  test('an SVG of the scene and one of the face maps are whole documents', async ({ lens, page }) => {
    await lens.open()

    await test.step('an SVG is a whole document of its own: vectors over one picture', async () => {
      await lens.button('Take away').click()
      const { name, bytes } = await downloaded(page, 'Download SVG')
      expect(name).toBe('looks-fine.svg')
      const seen = await page.evaluate(text => {
        const document = new DOMParser().parseFromString(text, 'image/svg+xml')
        return {
          error: document.querySelector('parsererror')?.textContent ?? null,
          images: Array.from(document.querySelectorAll('image'), image => image.getAttribute('href')?.slice(0, 22)),
          texts: Array.from(document.querySelectorAll('text'), text => text.textContent),
          classes: document.querySelectorAll('[class], style').length,
        }
      }, bytes.toString('utf8'))
      expect(seen).toMatchObject({ error: null, images: ['data:image/png;base64,'], classes: 0 })
      expect(seen.texts).toEqual(expect.arrayContaining(['min J = −0.010653', '7', 'jacdet on [0,1]³']))
    })

    await test.step('the face maps come as an SVG too, also while their panel is still closed', async () => {
      const { name, bytes } = await downloaded(page, 'Download SVG of the face maps')
      expect(name).toBe('looks-fine-face-maps.svg')
      const text = bytes.toString('utf8')
      expect(text.match(/<image /g)).toHaveLength(6)
      for (const face of ['−ξ', '+ξ', '−η', '+η', '−ζ', '+ζ']) expect(text).toContain(`>${face}</text>`)
      await expect(lens.button('Face maps')).toHaveAttribute('aria-expanded', 'true')
    })
  })
})

test('axe finds nothing in either panel, and both fit', async ({ lens, page }) => {
  await lens.open()
  await lens.button('Take away').click()
  await lens.button('Copy Python').click()
  await lens.button('Paste or drop').click()
  await pasteAnywhere(page, 'nothing')
  await expect(panelOf(page, 'Paste or drop')).toContainText('0 numbers were found')
  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page, '#panel-paste')
    await expectAxeFindsNothing(page, '#panel-take-away')
    for (const name of ['Paste or drop', 'Take away']) await expectLargeTargets(panelOf(page, name).getByRole('button'))
    await expectNoSidewaysOverflow(page)
  })
})

function readPasted(text: string): readonly number[] | undefined {
  const [mesh] = readMeshes(fileOfBytes('The text', new TextEncoder().encode(text)))
  return mesh && verticesOf(mesh, 0)
}

/** The share of pixels that are clearly blue: faces where jacdet is positive. */
function blueShare(page: Page, png: Buffer): Promise<number> {
  return page.evaluate(async base64 => {
    const image = new Image()
    image.src = `data:image/png;base64,${base64}`
    await image.decode()
    const canvas = Object.assign(document.createElement('canvas'), { width: 100, height: 100 })
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    context.drawImage(image, 0, 0, 100, 100)
    const { data } = context.getImageData(0, 0, 100, 100)
    let blue = 0
    for (let i = 0; i < data.length; i += 4) if ((data[i + 2] as number) > (data[i] as number) + 40) blue++
    return blue / 10_000
  }, png.toString('base64'))
}
