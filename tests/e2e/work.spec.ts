/** Walks that lost the reader's work: to another page and back, by reload, to a second tab, where the browser keeps nothing. */
import type { Page } from '@playwright/test'
import { expect, Lens, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const LAST = 'Your last element.'
const goTo = (page: Page, name: string) =>
  page.getByRole('navigation', { name: 'Hexlens' }).getByRole('link', { name }).click()
const note = (page: Page) => page.locator('.pages .note')
const history = (lens: Lens) => lens.element.evaluate(element => (element as Element).history)
const stateOf = (lens: Lens) => lens.element.evaluate(element => (element as Element).state)

async function type(lens: Lens, vertex: number, axis: 'x' | 'y' | 'z', value: string): Promise<void> {
  const before = lens.page.url()
  await lens.field(vertex, axis).fill(value)
  await lens.field(vertex, axis).press('Enter')
  await expect.poll(() => lens.page.url()).not.toBe(before)
}

async function backByLink(lens: Lens): Promise<void> {
  await goTo(lens.page, 'Lens')
  await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
}

// Wide enough for the numbers beside the scene.
test.use({ viewport: { width: 1350, height: 640 } })

test('the element, the view and undo survive the other pages, Back, a reload and a new tab', async ({
  lens,
  page,
  context,
}) => {
  await lens.open()
  await expect(note(page)).toBeEmpty()
  const first = await lens.bits()
  await lens.set((await lens.vertices()).with(0, -0).with(1, 0.1 + 0.2))
  await type(lens, 6, 'z', '0.75')
  await type(lens, 5, 'x', '1.25')
  await lens.button('Undo').click()
  await lens.scene.focus()
  await page.keyboard.press('d')
  await lens.button('Inside').click()
  await lens.nextFrame()
  const [made, steps, state] = [await lens.bits(), await history(lens), await stateOf(lens)]
  expect([steps.elements.length, steps.present]).toEqual([4, 2])
  const address = page.url()

  for (const other of ['Lessons', 'Gallery', 'Search', 'Challenges'])
    await test.step(`by the links to ${other} and back`, async () => {
      await goTo(page, other)
      await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
      await backByLink(lens)
      expect(page.url()).toBe(address)
      await expect(note(page)).toContainText(LAST)
      expect(await lens.bits()).toEqual(made)
      expect(await history(lens)).toEqual(steps)
      expect(await stateOf(lens)).toEqual(state)
    })

  await test.step('by Back and by a reload, which say nothing of it', async () => {
    await goTo(page, 'Lessons')
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    await page.goBack()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    expect(await history(lens)).toEqual(steps)
    expect(await stateOf(lens)).toEqual(state)
    await page.reload()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    expect(await history(lens)).toEqual(steps)
    await expect(note(page)).toBeEmpty()
  })

  await test.step('a second tab begins with it and has its own from then on', async () => {
    const other = new Lens(await context.newPage())
    await other.page.setViewportSize({ width: 1350, height: 640 })
    await other.open()
    await expect(note(other.page)).toContainText(LAST)
    expect(await history(other)).toEqual(steps)
    await type(other, 4, 'z', '3')
    await expect(note(other.page)).toBeEmpty()
    await goTo(other.page, 'Gallery')
    await page.reload()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    expect(await history(lens)).toEqual(steps)
    await goTo(page, 'Gallery')
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    await backByLink(other)
    expect((await other.vertices())[14]).toBe(3)
    await other.page.close()
    await backByLink(lens)
    expect(await history(lens)).toEqual(steps)
  })

  await test.step('a link shows its element, and what was before is one undo away', async () => {
    await goTo(page, 'Gallery')
    await page
      .getByRole('link', { name: 'Warped on the page Lens' })
      .or(page.locator('.links a').first())
      .first()
      .click()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    const linked = await lens.bits()
    expect(linked).not.toEqual(made)
    await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(made)
    for (let i = 0; i < 2; ++i) await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(first)
    await expect(lens.button('Undo')).toBeDisabled()
    await lens.button('Redo').click()
    await lens.button('Redo').click()
    await expect.poll(() => lens.bits()).toEqual(made)
  })

  await test.step('Start anew is a step, too', async () => {
    await goTo(page, 'Lessons')
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    await backByLink(lens)
    await page.getByRole('button', { name: 'Start anew' }).click()
    await expect.poll(() => lens.bits()).toEqual(first)
    await expect(note(page)).toBeEmpty()
    await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(made)
  })
})

test('a page shown again as it was left goes on with what another has kept since', async ({ lens, page }) => {
  await lens.open()
  await type(lens, 6, 'z', '0.75')
  const own = await history(lens)
  await page.evaluate(() => {
    const key = Object.keys(sessionStorage).find(name => name.startsWith('hexlens-lens-'))
    dispatchEvent(new PageTransitionEvent('pagehide', { persisted: true }))
    const kept = sessionStorage.getItem(key ?? 'hexlens-lens-1') ?? ''
    const work = JSON.parse(kept)
    const [element] = work.history.elements
    work.history.elements.push({ ...element, vertices: element.vertices.with(2, 0.5) })
    work.history.present += 1
    work.state = { ...work.state, vertices: element.vertices.with(2, 0.5) }
    sessionStorage.setItem('hexlens-lens-1', JSON.stringify(work))
    dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))
  })
  await lens.nextFrame()
  const { elements, present } = await history(lens)
  // What the address names is shown, and the other's element is one undo away.
  expect(elements).toHaveLength(own.elements.length + 2)
  expect(elements[present]).toEqual(own.elements[own.present])
  expect(elements[present - 1]?.vertices[2]).toBe(0.5)
})

test.describe('where the browser', () => {
  const refusals = {
    'stores nothing': () => {
      for (const name of ['sessionStorage', 'localStorage'])
        Object.defineProperty(globalThis, name, {
          get() {
            throw new DOMException('refused', 'SecurityError')
          },
        })
    },
    'has no room': () => {
      Storage.prototype.setItem = () => {
        throw new DOMException('full', 'QuotaExceededError')
      }
    },
  }
  for (const [what, refuse] of Object.entries(refusals))
    test(`${what}, all works and a sentence says what is lost`, async ({ lens, page }) => {
      await page.addInitScript(refuse)
      await lens.open()
      await expect(note(page)).toBeEmpty()
      await type(lens, 6, 'z', '0.75')
      await expect(note(page)).toContainText('What you do here is gone when you leave it.')
      const made = await lens.bits()
      await page.reload()
      await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
      expect(await lens.bits()).toEqual(made) // the address has it
      for (const other of ['lessons', 'challenges', 'gallery']) await lens.open(`${other}.html`)
    })
})

test('what a later version or somebody else has stored is left alone', async ({ lens, page }) => {
  await page.addInitScript(() => {
    localStorage.setItem('hexlens-lens-2', 'later')
    localStorage.setItem('hexlens-lens-1', '{"state":{"version":9},"history":{"version":9}}')
    sessionStorage.setItem('hexlens-entries-1', '[7]')
  })
  await lens.open()
  await expect(lens.preset).toHaveValue('looks-fine')
  await expect(note(page)).toBeEmpty()
  expect(await page.evaluate(() => localStorage.getItem('hexlens-lens-2'))).toBe('later')
})
