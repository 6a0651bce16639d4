/** Walks that lost the reader's work: to another page and back, by reload, to a second tab, where the browser keeps nothing. */
import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { drop } from './input'
import { expect, Lens, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const LIST = new URL('../../../shared/pastes/44-calculix-6000.inp', import.meta.url)
const LAST = 'Your last element.'
const note = (page: Page) => page.locator('.pages .note')
const history = (lens: Lens) => lens.element.evaluate(element => (element as Element).history)
const stateOf = (lens: Lens) => lens.element.evaluate(element => (element as Element).state)

async function goTo(page: Page, name: string): Promise<void> {
  const pages = page.getByRole('navigation', { name: 'Hexlens' })
  await pages.getByRole('link', { name }).click()
  await expect(pages.locator('[aria-current=page]')).toHaveText(name)
}

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
      await backByLink(lens)
      expect(page.url()).toBe(address)
      await expect(note(page)).toContainText(LAST)
      expect(await lens.bits()).toEqual(made)
      await expect.poll(() => history(lens)).toEqual(steps)
      expect(await stateOf(lens)).toEqual(state)
    })

  await test.step('by Back and by a reload, which say nothing of it', async () => {
    await goTo(page, 'Lessons')
    await page.goBack()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    await expect.poll(() => history(lens)).toEqual(steps)
    expect(await stateOf(lens)).toEqual(state)
    await page.reload()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    await expect.poll(() => history(lens)).toEqual(steps)
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
    await expect.poll(() => history(lens)).toEqual(steps)
    await goTo(page, 'Gallery')
    await backByLink(other)
    expect((await other.vertices())[14]).toBe(3)
    await other.page.close()
    await backByLink(lens)
    await expect.poll(() => history(lens)).toEqual(steps)
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
    await backByLink(lens)
    await page.getByRole('button', { name: 'Start anew' }).click()
    await expect.poll(() => lens.bits()).toEqual(first)
    await expect(note(page)).toBeEmpty()
    await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(made)
  })
})

test('a list that was read is there again, until it is closed', async ({ lens, page }) => {
  const list = page.getByRole('listbox')
  await lens.open()
  await drop(lens.scene, { files: [{ name: '44-calculix-6000.inp', bytes: readFileSync(LIST) }] })
  await expect(list).toBeFocused()
  await page.keyboard.press('Enter')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await lens.nextFrame()
  const chosen = await history(lens)
  await expect.poll(() => page.evaluate(() => sessionStorage.getItem('hexlens-list-1'))).not.toBeNull()

  await goTo(page, 'Gallery')
  await backByLink(lens)
  await expect(page.getByRole('region', { name: 'What was read' })).toContainText('6000 hexahedra')
  await expect(list).toBeVisible()
  await expect(list).not.toBeFocused()
  await expect.poll(() => history(lens)).toEqual(chosen)
  await page.reload()
  await expect(list).toBeVisible()
  await lens.button('Close the list').click()
  await page.reload()
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await lens.nextFrame()
  await expect(list).toHaveCount(0)
  await expect.poll(() => history(lens)).toEqual(chosen)
})

test('a list that cannot be kept is said to be gone on leaving', async ({ lens, page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(globalThis, 'indexedDB', { value: undefined })
  })
  await lens.open()
  await drop(lens.scene, { files: [{ name: '44-calculix-6000.inp', bytes: readFileSync(LIST) }] })
  await expect(note(page)).toHaveText('The list is gone when you leave this page: this browser does not keep it.')
  await lens.button('Close the list').click()
  await expect(note(page)).toBeEmpty()
})

test('what is chosen in Copy embed is there again', async ({ lens, page }) => {
  await lens.open()
  await lens.button('Copy embed').click()
  await page.getByRole('textbox', { name: 'Height' }).fill('640')
  await page.getByRole('textbox', { name: 'Height' }).press('Enter')
  await page.getByRole('combobox', { name: 'For' }).selectOption('Sphinx')
  await page.getByRole('textbox', { name: 'Description' }).fill('Mine')
  await page.getByRole('textbox', { name: 'Description' }).press('Enter')
  await goTo(page, 'Gallery')
  await backByLink(lens)
  await expect(page.getByRole('textbox', { name: 'Height' })).toHaveValue('640')
  await expect(page.getByRole('combobox', { name: 'For' })).toHaveValue(/Sphinx/)
  await expect(page.getByRole('textbox', { name: 'Description' })).toHaveValue('Mine')
})

test('each step of a lesson has its own element and undo', async ({ lens, page }) => {
  const title = page.locator('.step[data-active] h2')
  await lens.open('lessons.html#corners-are-not-enough/2')
  await expect(title).toHaveText(/Between two corners/)
  const begun = await lens.bits()
  await lens.scene.focus()
  await page.keyboard.press('5')
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowRight')
  await expect.poll(() => lens.bits()).not.toEqual(begun)
  const [made, steps] = [await lens.bits(), await history(lens)]
  expect(steps.elements.length).toBeGreaterThan(1)

  await page.getByRole('button', { name: 'Next', exact: true }).click()
  await expect(title).toHaveText(/The centre as well/)
  expect((await history(lens)).elements).toHaveLength(1)
  await page.getByRole('button', { name: 'Previous', exact: true }).click()
  await expect(title).toHaveText(/Between two corners/)
  await expect.poll(() => history(lens)).toEqual(steps)

  await goTo(page, 'Challenges')
  await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
  await lens.open('lessons.html#corners-are-not-enough/2')
  await expect(page.getByText('You have changed the element.')).toBeVisible()
  expect(await lens.bits()).toEqual(made)
  await page.reload()
  await expect(page.getByText('You have changed the element.')).toBeVisible()
  await expect.poll(() => history(lens)).toEqual(steps)
  await page.getByRole('button', { name: 'Restore this step' }).click()
  await expect.poll(() => lens.bits()).toEqual(begun)
  await lens.scene.focus()
  await page.keyboard.press('Control+z')
  await expect.poll(() => lens.bits()).toEqual(made)
})

test('a step in the plane, too', async ({ page }) => {
  await page.goto('lessons.html#quadrilaterals-first/1')
  const undo = page.locator('.plane').getByRole('button', { name: 'Undo' })
  await expect(undo).toBeDisabled()
  await page.locator('.plane').getByRole('application').first().focus()
  await page.keyboard.press('2')
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowRight')
  await expect(undo).toBeEnabled()
  await page.getByRole('button', { name: 'Next', exact: true }).click()
  await expect(undo).toBeDisabled()
  await page.goto('gallery.html')
  await page.goto('lessons.html#quadrilaterals-first/1')
  await expect(undo).toBeEnabled()
})

test('each challenge has its own element and undo', async ({ lens, page }) => {
  await lens.open('challenges.html#challenge=one-vertex')
  await type(lens, 6, 'z', '0.75')
  await type(lens, 6, 'z', '-0.125')
  const [made, steps] = [await lens.bits(), await history(lens)]
  await page.getByRole('link', { name: 'All challenges' }).click()
  await page.getByRole('link', { name: 'Touch zero exactly' }).click()
  await expect(page.getByRole('heading', { name: 'Touch zero exactly' })).toBeVisible()
  expect((await history(lens)).elements).toHaveLength(1)
  await goTo(page, 'Lessons')
  await expect(page.locator('.column h1')).toBeVisible()
  await goTo(page, 'Challenges')
  await page.getByRole('link', { name: 'Break it with one vertex' }).click()
  await expect(page.locator('#column .outcome')).toHaveText('Solved: every condition holds.')
  expect(await lens.bits()).toEqual(made)
  await expect.poll(() => history(lens)).toEqual(steps)
  expect(page.url()).toContain('vertices=')
  for (const value of ['0.75', '1']) {
    await page.locator('#column').getByRole('button', { name: 'Undo' }).click()
    await expect(lens.field(6, 'z')).toHaveValue(value)
  }
})

test('a challenge half written survives Back, a reload and another page, and is discarded on request', async ({
  lens,
  page,
  context,
}) => {
  const column = page.locator('#column')
  const fields = {
    Title: 'Half',
    'What it is about': 'Not <b>done</b>',
    'The conditions as text': 'valid\nboundary',
    Hint: 'None',
  }
  const expectDraft = async (on: Page = page) => {
    for (const [label, value] of Object.entries(fields))
      await expect(on.locator('#column').getByLabel(label)).toHaveValue(value)
    await expect(on.locator('#column')).toContainText('The start is taken.')
  }
  await lens.open('challenges.html#write')
  await lens.set((await lens.vertices()).with(0, -0))
  await column.getByRole('button', { name: 'Take the element as the start' }).click()
  await column.getByText('The conditions as text').click()
  for (const [label, value] of Object.entries(fields)) await column.getByLabel(label).fill(value)
  await column.getByRole('link', { name: 'All challenges' }).click()
  await expect(column.getByLabel('Title')).toBeHidden()
  await page.goBack()
  await expectDraft()
  await page.reload()
  await expectDraft()
  await goTo(page, 'Gallery')
  await goTo(page, 'Challenges')
  await column.getByRole('link', { name: 'write one' }).click()
  await expectDraft()

  const other = await context.newPage()
  await other.goto('challenges.html#write')
  await expectDraft(other)
  await other.locator('#column').getByLabel('Title').fill('Another')
  await other.close()
  await page.reload()
  await expectDraft()

  await column.getByRole('button', { name: 'Discard the draft' }).click()
  await expect(column.getByLabel('Title')).toHaveValue('')
  await column.getByRole('button', { name: 'Bring the draft back' }).click()
  await expectDraft()
  await column.getByRole('button', { name: 'Discard the draft' }).click()
  await page.reload()
  await expect(column.getByLabel('Title')).toHaveValue('')
  await expect(column).toContainText('Until one is taken, the start is the element as it is.')
})

test('an element changed in the gallery is there again, and the address says that it is another', async ({
  lens,
  page,
}) => {
  await lens.open('gallery.html')
  await page.getByRole('button').and(page.locator('.picture')).nth(1).click()
  await expect.poll(() => page.url()).toContain('#')
  const named = page.url()
  await lens.scene.focus()
  await page.keyboard.press('6')
  await page.keyboard.press('Shift+ArrowRight')
  await expect.poll(() => page.url()).not.toContain('#')
  const steps = await history(lens)
  await goTo(page, 'Lens')
  await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
  await goTo(page, 'Gallery')
  await expect.poll(() => history(lens)).toEqual(steps)
  await lens.scene.focus()
  await page.keyboard.press('Control+z')
  await expect.poll(() => page.url()).toBe(named)
})

test('a page shown again as it was left goes on with what another has kept since', async ({ lens, page }) => {
  await lens.open()
  await type(lens, 6, 'z', '0.75')
  const own = await history(lens)
  await page.evaluate(() => {
    dispatchEvent(new PageTransitionEvent('pagehide', { persisted: true }))
    const work = JSON.parse(sessionStorage.getItem('hexlens-lens-1') ?? '')
    work.history.steps.push({ vertices: [2, 0.5] })
    work.history.present += 1
    work.state.vertices[2] = 0.5
    sessionStorage.setItem('hexlens-lens-1', JSON.stringify(work))
    dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))
  })
  await lens.nextFrame()
  const { elements, present } = await history(lens)
  // The address's element is shown, and the other's is one undo away.
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
      for (const other of ['lessons.html#corners-are-not-enough/2', 'challenges.html', 'gallery.html'])
        await lens.open(other)
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
