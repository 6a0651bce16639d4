/** Pictures of every page and panel, light on a desktop and dark on a phone. `npm run snapshots` takes them anew. */
import type { Locator, Page } from '@playwright/test'
import { appPages } from '../../tools/pages.mjs'
import { expect, type Lens, test } from '../e2e/lens'

// Every pixel of the faces counts.
test.use({ pictureRatio: 1 })

interface Look {
  readonly look: string
  readonly colorScheme: 'light' | 'dark'
  readonly width: number
  readonly height: number
}

const DESKTOP: Look = { look: 'desktop', colorScheme: 'light', width: 900, height: 560 }
const PHONE: Look = { look: 'phone', colorScheme: 'dark', width: 360, height: 720 }

/** With the lens; a fixed seed, so that the page of the search says the same again. */
const ADDRESSES: Record<string, string> = {
  index: './',
  lessons: './lessons.html#what-the-jacobian-determinant-is/1',
  search: './search.html?find=edges&seed=11',
}

async function inLooks(lens: Lens, looks: readonly Look[], take: (look: string) => Promise<void>): Promise<void> {
  for (const { look, colorScheme, width, height } of looks) {
    await lens.page.emulateMedia({ colorScheme, reducedMotion: 'reduce' })
    await lens.page.setViewportSize({ width, height })
    await lens.nextFrame()
    await take(look)
  }
}

/** Pictures that a page draws in its own time have come, as far as they are in view. */
async function everyPictureIsThere(page: Page): Promise<void> {
  const areThere = () =>
    page.locator('img:visible').evaluateAll(images =>
      images.every(image => {
        const { naturalWidth } = image as HTMLImageElement
        return naturalWidth > 0 || image.getBoundingClientRect().top > innerHeight
      }),
    )
  await expect.poll(areThere).toBe(true)
}

/** The other two pairs of width and scheme, for the lens alone. */
const MORE: Record<string, readonly Look[]> = {
  index: [
    { ...PHONE, look: 'phone-light', colorScheme: 'light' },
    { ...DESKTOP, look: 'desktop-dark', colorScheme: 'dark' },
  ],
}

for (const { file } of appPages)
  test(`the page ${file}`, async ({ lens, page }) => {
    // So wide that its lens is in sight.
    if (file === 'mesh') await page.setViewportSize({ width: 1240, height: DESKTOP.height })
    await lens.open(ADDRESSES[file] ?? `./${file}.html`)
    await inLooks(lens, [DESKTOP, PHONE, ...(MORE[file] ?? [])], async look => {
      await everyPictureIsThere(page)
      await expect.soft(page).toHaveScreenshot(`${file}-${look}.png`)
    })
  })

test('the overview of the lessons, and the lesson in the plane', async ({ lens, page }) => {
  for (const [name, address, shown] of [
    ['overview', './lessons.html', '.overview'],
    ['plane', './lessons.html#quadrilaterals-first/5', '.plane .verdict .invalid'],
  ] as const) {
    await page.goto(address)
    await expect(page.locator(shown)).toBeVisible()
    await inLooks(lens, [DESKTOP, PHONE], look => expect.soft(page).toHaveScreenshot(`lessons-${name}-${look}.png`))
  }
})

test('the page embed', async ({ lens, page }) => {
  await lens.open('./embed.html?views=scene+verdict+checks&controls=none')
  await inLooks(lens, [DESKTOP, PHONE], look => expect(page).toHaveScreenshot(`embed-${look}.png`))
})

/** So high that no panel is cut off where it scrolls beside the scene. */
const HIGH: Look = { ...DESKTOP, height: 1600 }
const ALWAYS_SHOWN = ['verdict', 'checks', 'vertices']

test('every panel', async ({ lens, page }) => {
  await lens.open()
  const opened: string[] = []
  await inLooks(lens, [HIGH, PHONE], async look => {
    for (const part of ALWAYS_SHOWN)
      await expect.soft(page.locator(`hex-lens .${part}`).first()).toHaveScreenshot(`panel-${part}-${look}.png`)
    for (const fold of await page.locator('hex-lens .fold').all()) {
      const button = fold.locator('> h2 > button')
      if (!(await button.isVisible())) continue
      const name = (await button.innerText()).trim()
      opened.push(name)
      await button.click()
      await expect(fold.locator('> div')).not.toBeEmpty()
      await everyLensIsDrawn(fold)
      await expect.soft(fold).toHaveScreenshot(`panel-${name.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-')}-${look}.png`)
      await button.click()
    }
  })
  expect(opened.length).toBeGreaterThan(12)
})

/** The preview of "Copy embed" is drawn when it is first seen. */
async function everyLensIsDrawn(part: Locator): Promise<void> {
  for (const lens of await part.locator('hex-lens').all()) {
    await lens.scrollIntoViewIfNeeded()
    const isDrawn = () => lens.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).complete)
    await expect.poll(isDrawn).toBe(true)
  }
}
