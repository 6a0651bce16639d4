/** A teacher's walk and a student's: conditions by choosing, a series in one link, what is handed in, one side to print. */
import type { Locator, Page } from '@playwright/test'
import jsQR from 'jsqr'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'
import { readPdf } from './pdf'

const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
/** The numbers stand beside the scene. */
const ROOMY = { width: 1350, height: 700 }

const column = (page: Page) => page.locator('#column')
const outcome = (page: Page) => page.locator('#column .outcome')
const condition = (page: Page, n: number) => column(page).getByRole('combobox', { name: `Condition ${n}`, exact: true })
const button = (page: Page, name: string | RegExp) => column(page).getByRole('button', { name })

async function openPage({ page, ...lens }: Lens, address: string): Promise<void> {
  await page.goto('about:blank')
  await page.goto(address)
  await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
}

/** Links are read from a field: a page that is tested may not copy. */
async function withoutClipboard(page: Page): Promise<void> {
  await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }))
}

async function writeNarrowing(page: Page, title: string): Promise<void> {
  await column(page).getByRole('textbox', { name: 'Title' }).fill(title)
  await column(page).getByLabel('What it is about').fill('Keep it valid,\nwith J < 1/8 somewhere.')
  await condition(page, 1).selectOption('Valid')
  await condition(page, 2).selectOption('Boundary minimum')
  await column(page).getByRole('combobox', { name: 'Condition 2, comparison' }).selectOption('< less than')
  await column(page).getByRole('textbox', { name: 'Condition 2, number' }).fill('1/8')
}

async function type(lens: Lens, vertex: number, axis: 'x' | 'y' | 'z', value: string): Promise<void> {
  await lens.field(vertex, axis).fill(value)
  await lens.field(vertex, axis).press('Enter')
}

test('a teacher chooses conditions, sees them judged, and puts a series into one link; a student hands it in', async ({
  lens,
  page,
}) => {
  await withoutClipboard(page)
  await page.setViewportSize(ROOMY)
  await openPage(lens, './challenges.html#write')
  await lens.set(CUBE)
  const preview = column(page).locator('.preview')

  await test.step('conditions are chosen, and judged as they stand', async () => {
    await writeNarrowing(page, 'Squeeze it')
    await expect(preview).toContainText('Squeeze it')
    await expect(preview.getByRole('listitem')).toHaveText([
      /Met:\s*Valid\s*, now it is valid/,
      /Not met:\s*Boundary minimum < 1\/8\s*, now 1/,
    ])
    await button(page, 'Add a condition').click()
    await condition(page, 3).selectOption('Moved vertices')
    const number = column(page).getByRole('textbox', { name: 'Condition 3, number' })
    await number.fill('one')
    await expect(number).toHaveAccessibleDescription(/“one” is not a name that a condition knows/)
    await expect(preview).toContainText('Condition 3 is not understood.')
    await number.fill('1')
    await column(page).getByRole('combobox', { name: 'Condition 3, comparison' }).selectOption('≤ at most')
    await expect(preview.getByRole('listitem').nth(2)).toHaveText(/Met:\s*Moved vertices ≤ 1\s*, now 0/)
  })

  await test.step('a solution is judged by the core, not believed', async () => {
    await button(page, 'Take the element as the start').click()
    await button(page, 'Take the element as a solution').click()
    await expect(preview).toContainText('The solution does not fulfil condition 2.')
    await type(lens, 6, 'z', '0.0625')
    await expect(preview.getByRole('listitem').nth(1)).toHaveText(/Met:\s*Boundary minimum < 1\/8\s*, now 1\/16/)
    await button(page, 'Take the element as a solution').click()
    await expect(preview).toContainText('The solution fulfils every condition.')
  })

  await test.step('others follow, in the order that is chosen', async () => {
    await column(page).getByRole('combobox', { name: 'Add one of this page’s' }).selectOption('one-vertex')
    await button(page, 'Add another challenge').click()
    const titles = column(page).locator('.series-title')
    await expect(titles).toHaveText(['Squeeze it', 'Break it with one vertex', 'Untitled'])
    await button(page, 'Make the link').click()
    await expect(column(page).getByRole('alert')).toHaveText('Challenge 3: The title is empty.')
    await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page))
    await page.setViewportSize(ROOMY)
    await expectLargeTargets(column(page).locator('button, input, textarea, summary, select'))
    await button(page, 'Remove 3, Untitled').click()
    await button(page, 'Move 2, Break it with one vertex up').click()
    await expect(titles).toHaveText(['Break it with one vertex', 'Squeeze it'])
    await titles.nth(1).click()
    await expect(column(page).getByRole('textbox', { name: 'Title' })).toHaveValue('Squeeze it')
    expect(await lens.vertices()).toEqual(CUBE)
    await button(page, 'Make the link').click()
  })

  const link = await column(page).getByRole('textbox', { name: 'Link to the challenge' }).inputValue()
  expect(link).toMatch(/#series=[\w-]+$/)

  await test.step('a student solves the first, skips nothing, and finds it again after a reload', async () => {
    await openPage(lens, link)
    await expect(column(page)).toContainText('1 of 2 in this series')
    await expect(column(page).getByRole('link', { name: 'Skip to: Squeeze it' })).toBeVisible()
    await type(lens, 6, 'z', '-0.125')
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    await column(page).getByRole('link', { name: 'Next: Squeeze it' }).click()
    await expect(column(page).getByRole('heading', { name: 'Squeeze it' })).toBeFocused()
    await expect(column(page)).toContainText('2 of 2 in this series')
    await expect(column(page).getByRole('link', { name: '1 Break it with one vertex, solved' })).toBeVisible()
    expect(await lens.vertices()).toEqual(CUBE)
    await type(lens, 0, 'x', '-0')
    await type(lens, 6, 'z', '0.1')
    await expect(column(page)).toContainText('All 2 are solved: the link to hand in is below.')
    await page.reload()
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    await expect(column(page).getByRole('link', { name: '2 Squeeze it, solved' })).toBeVisible()
    await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page))
    await page.setViewportSize(ROOMY)
    await expectLargeTargets(column(page).locator('button, summary, .series-places a'))
  })

  await test.step('and hands both in: the teacher sees them judged anew', async () => {
    const solution = await lens.bits()
    await column(page).getByLabel('Your name, if you like').fill('<b>Ada')
    await button(page, 'Copy link to hand in').click()
    await expect(column(page)).toContainText('Your name is plain text, but it holds “<b”, which looks like HTML.')
    await column(page).getByLabel('Your name, if you like').fill('Ada & Grace < 3')
    await button(page, 'Copy link to hand in').click()
    const handedIn = await column(page).getByRole('textbox', { name: 'Link to hand in' }).inputValue()
    await page.evaluate(() => localStorage.clear())
    await openPage(lens, handedIn)
    await expect(column(page).getByRole('heading', { name: 'Handed in by Ada & Grace < 3' })).toBeVisible()
    await expect(outcome(page)).toHaveText('2 of 2 solved.')
    const parts = column(page).locator('.handed-in')
    await expect(parts.nth(0)).toContainText('1. Break it with one vertex: solved')
    await expect(parts.nth(0)).toContainText(
      '1 vertex is moved from the start. It is not the stored solution: 1 vertex differs.',
    )
    await expect(parts.nth(1).getByRole('listitem').nth(1)).toHaveText(/Met:.*Boundary minimum ≈ 0\.1/s)
    await button(page, 'Show element 2 in the lens').click()
    expect(await lens.bits()).toEqual(solution)
    await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page))
    await page.setViewportSize(ROOMY)
    await lens.set(CUBE)
    await expect(outcome(page)).toHaveText('2 of 2 solved.')
    expect(page.url()).toBe(handedIn)
  })
})

test('a link that is cut off, and a series without that many challenges, say so', async ({ lens, page }) => {
  await withoutClipboard(page)
  await openPage(lens, './challenges.html#challenge=one-vertex')
  await column(page).getByText('Hand in, print').click()
  await button(page, 'Copy link to hand in').click()
  const link = await column(page).getByRole('textbox', { name: 'Link to hand in' }).inputValue()
  await openPage(lens, link)
  await expect(outcome(page)).toHaveText('0 of 1 solved.')
  await expect(column(page).getByRole('listitem').first()).toHaveText(/Not met:.*it is valid/s)
  await openPage(lens, link.slice(0, -9))
  await expect(column(page).getByRole('alert')).toHaveText('The link is broken: what it holds is cut off or changed.')
})

/** Letters that do not deflate well. */
function lettersAtRandom(seed: number, count: number): string {
  let state = seed
  return Array.from({ length: count }, () => {
    state = (state * 1_103_515_245 + 12_345) % 2 ** 31
    return String.fromCharCode(97 + (Math.floor(state / 2 ** 16) % 26))
  }).join('')
}

/** The text of the QR code, as a camera would read it from the picture. */
async function scanned(page: Page, code: Locator): Promise<string | undefined> {
  const picture = (await code.screenshot()).toString('base64')
  const { base64, width, height } = await page.evaluate(async base64 => {
    const image = new Image()
    image.src = `data:image/png;base64,${base64}`
    await image.decode()
    const canvas = document.createElement('canvas')
    canvas.width = image.width
    canvas.height = image.height
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    context.drawImage(image, 0, 0)
    const { data } = context.getImageData(0, 0, image.width, image.height)
    const reader = new FileReader()
    reader.readAsDataURL(new Blob([data]))
    await new Promise(resolve => reader.addEventListener('load', resolve))
    // A list of millions of numbers would take seconds on its way.
    const [, bytes = ''] = (reader.result as string).split(',')
    return { base64: bytes, width: image.width, height: image.height }
  }, picture)
  return jsQR(new Uint8ClampedArray(Buffer.from(base64, 'base64')), width, height)?.data
}

test.describe('on paper', () => {
  test.use({ colorScheme: 'dark', deviceScaleFactor: 2 })

  test('a challenge is one side, with its picture and a QR code of its link', async ({ lens, page }) => {
    await page.addInitScript(() => {
      window.print = () => {}
    })
    await openPage(lens, './challenges.html#challenge=most-twisted')
    await column(page).getByText('Hand in, print').click()
    await button(page, 'Print on one side').click()
    await expect(column(page)).toContainText('The side is ready to be printed.')
    const link = new URL('#challenge=most-twisted', page.url()).href
    for (const format of ['A4', 'Letter'] as const) {
      const { pages, pictures } = readPdf(await page.pdf({ format }))
      expect(pages).toHaveLength(1)
      for (const words of [
        'The most twisted cube',
        'Twist ≥ 150',
        'Moved vertices ≤ 4',
        'the greatest wins',
        '−1/2',
        link,
      ])
        expect(pages[0]).toContain(words)
      for (const words of ['Undo', 'All challenges', 'VALID']) expect(pages[0]).not.toContain(words)
      expect(pictures.length).toBeGreaterThan(0)
    }
    await page.emulateMedia({ media: 'print' })
    expect(await scanned(page, page.getByRole('img', { name: 'QR code of the link' }))).toBe(link)
    await page.emulateMedia({ media: 'screen' })
    await column(page).getByRole('link', { name: 'All challenges' }).click()
    await expect(page.locator('.sheet')).toHaveCount(0)
  })

  test('so is a series; of more than a QR code or a side holds a sentence says so', async ({ lens, page }) => {
    await withoutClipboard(page)
    await page.addInitScript(() => {
      window.print = () => {}
    })
    await page.setViewportSize(ROOMY)
    await openPage(lens, './challenges.html#write')
    await lens.set(CUBE.with(0, -0.1 - 0.2))
    await writeNarrowing(page, 'Squeeze it')
    for (const id of ['touch-zero', 'edges-positive', 'depth-guard'])
      await column(page).getByRole('combobox', { name: 'Add one of this page’s' }).selectOption(id)
    await button(page, 'Make the link').click()
    const link = await column(page).getByRole('textbox', { name: 'Link to the challenge' }).inputValue()
    const said = column(page).getByRole('status').filter({ hasText: 'side' })
    await button(page, 'Print on one side').click()
    await expect(said).toHaveText('The side is ready to be printed.')
    for (const format of ['A4', 'Letter'] as const) {
      const { pages } = readPdf(await page.pdf({ format }))
      expect(pages).toHaveLength(1)
      for (const words of ['4 challenges', '1. Squeeze it', '4. Valid, though', '−0.30000000000000004', link])
        expect(pages[0]).toContain(words)
    }
    await page.emulateMedia({ media: 'print' })
    expect(await scanned(page, page.getByRole('img', { name: 'QR code of the link' }))).toBe(link)
    await page.emulateMedia({ media: 'screen' })

    for (const n of [1, 2, 3, 4]) {
      await button(page, 'Add another challenge').click()
      await column(page).getByRole('textbox', { name: 'Title' }).fill(`Number ${n}`)
      await column(page).getByLabel('What it is about').fill(lettersAtRandom(n, 1200))
    }
    await button(page, 'Make the link').click()
    await button(page, 'Print on one side').click()
    await expect(said).toHaveText(
      /^It is too much for one side: .* The link is too long for a QR code: it has \d+ bytes, and 2953 are the most\.$/,
    )
    expect(readPdf(await page.pdf({ format: 'A4' })).pages.length).toBeGreaterThan(1)
  })
})
