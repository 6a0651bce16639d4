import { expect, test } from './lens'

test('typing moves the vertex, in full precision and as one step to undo', async ({ lens, page }) => {
  await lens.open()

  await test.step('typing moves the vertex with every key, and one visit to a field is one step to undo', async () => {
    const before = await lens.vertices()
    const field = lens.field(6, 'z')
    await field.click()
    await field.press('Control+a')
    await field.pressSequentially('0.625')
    await lens.nextFrame()
    expect((await lens.vertices())[20]).toBe(0.625)
    await expect(field).toHaveValue('0.625')
    await lens.button('Undo').click()
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual(before)
    await expect(lens.button('Undo')).toBeDisabled()
    await lens.button('Redo').click()
    await lens.nextFrame()
    expect((await lens.vertices())[20]).toBe(0.625)
  })

  await test.step('Reset goes back to where the element started, and that too can be undone', async () => {
    await lens.button('Undo').click()
    await lens.nextFrame()
    const first = await lens.vertices()
    await lens.field(0, 'x').fill('0.5')
    await lens.field(7, 'z').fill('-2')
    await lens.field(7, 'z').press('Enter')
    await lens.nextFrame()
    const moved = await lens.vertices()
    await lens.button('Reset').click()
    await expect.poll(() => lens.vertices()).toEqual(first)
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(moved)
  })

  await test.step('what is typed in the very frame of an undo changes that coordinate alone', async () => {
    const first = await lens.vertices()
    await lens.field(6, 'x').fill('0.75')
    await lens.field(6, 'x').press('Enter')
    await lens.nextFrame()
    await lens.element.evaluate(element => {
      ;(element as HTMLElementTagNameMap['hex-lens']).undo()
      const field = (element.shadowRoot as ShadowRoot).querySelectorAll<HTMLInputElement>('.vertices input')[19]
      if (field === undefined) throw new Error('There is no field of vertex 6 y.')
      field.focus()
      field.value = '0.625'
      field.dispatchEvent(new InputEvent('input', { bubbles: true }))
    })
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual(first.with(19, 0.625))
  })

  await test.step('two fields filled in the same frame both count', async () => {
    await lens.element.evaluate(element => {
      const fields = (element.shadowRoot as ShadowRoot).querySelectorAll<HTMLInputElement>('.vertices input')
      for (const [index, text] of [
        [18, '0.25'],
        [19, '0.5'],
        [20, '0.75'],
      ] as const) {
        const field = fields[index] as HTMLInputElement
        field.focus()
        field.value = text
        field.dispatchEvent(new InputEvent('input', { bubbles: true }))
      }
    })
    await lens.nextFrame()
    expect((await lens.vertices()).slice(18, 21)).toEqual([0.25, 0.5, 0.75])
  })

  await test.step('the wheel over a field changes nothing', async () => {
    const before = await lens.vertices()
    await lens.field(4, 'x').click()
    await page.mouse.wheel(0, 120)
    await page.mouse.wheel(0, -360)
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual(before)
  })

  await test.step('fields hold the number in full, and the shortest text for it', async () => {
    const vertices = await lens.vertices()
    vertices.splice(0, 3, 0.1 + 0.2, -0, 5e-324)
    await lens.set(vertices)
    await expect(lens.field(0, 'x')).toHaveValue('0.30000000000000004')
    await expect(lens.field(0, 'y')).toHaveValue('-0')
    await expect(lens.field(0, 'z')).toHaveValue('5e-324')
  })
})

test('what is typed is taken back by Escape, and refused in a sentence where it is no number', async ({
  lens,
  page,
}) => {
  await lens.open()

  await test.step('Escape takes back what was typed', async () => {
    const before = await lens.vertices()
    const field = lens.field(2, 'x')
    const text = await field.inputValue()
    await field.click()
    await field.press('Control+a')
    await field.pressSequentially('77')
    await expect.poll(async () => (await lens.vertices())[6]).toBe(77)
    await field.press('Escape')
    await expect(field).toHaveValue(text)
    expect(await lens.vertices()).toEqual(before)
    await expect(lens.button('Undo')).toBeDisabled()
  })

  for (const [what, text] of Object.entries({
    'an empty field': '',
    'an infinite number': '1e999',
    'half a number': '1e',
    'half a fraction': '1/',
    'a comma that may be a separator': '1,234',
    'two numbers': '1 2',
    'a word': 'one',
  }))
    await test.step(`${what} is refused in a sentence, and the last good element stays`, async () => {
      const before = await lens.vertices()
      const field = lens.field(5, 'y')
      await field.click()
      await field.press('Control+a')
      await field.press('Delete')
      await field.pressSequentially(text)
      const sentence = page.getByText(/^Vertex 5 y: .* is kept\.$/)
      await expect(sentence).toContainText(text === '' ? 'A number is missing.' : `“${text}” `)
      await expect(field).toHaveAttribute('aria-invalid', 'true')
      await expect(field).toHaveAccessibleDescription(await sentence.innerText())
      await field.blur()
      await lens.nextFrame()
      await expect(field).toHaveValue(text)
      expect(await lens.vertices()).toEqual(before)
      await expect(lens.button('Undo')).toBeDisabled()
      await expect(sentence).toBeVisible()
      await field.fill('2')
      await expect(sentence).toBeHidden()
      expect((await lens.vertices())[16]).toBe(2)
      await field.press('Escape')
      expect(await lens.vertices()).toEqual(before)
    })
})

/** At each size at which it went wrong; every text is at one of them, since the size is nothing to the parser. */
const TYPED = [
  { width: 1440, height: 900, numbers: { '1/3': 1 / 3, '1½': 1.5 }, refused: ['1.234,5', '[[0,0,0],[1,0,0]]'] },
  { width: 1024, height: 768, numbers: { '1/3': 1 / 3, '−1/8': -0.125 }, refused: ['1/0'] },
  { width: 390, height: 844, numbers: { '1/3': 1 / 3, '0,25': 0.25, '2e−3': 0.002 }, refused: ['0.1 0.2'] },
]

test('fractions, true minus signs and decimal commas are understood as they are typed', async ({
  lens,
  page,
  context,
}) => {
  await lens.open()
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  const before = await lens.vertices()
  const field = lens.field(2, 'y')
  for (const { width, height, numbers, refused } of TYPED)
    await test.step(`at ${width} pixels`, async () => {
      await page.setViewportSize({ width, height })
      for (const [text, value] of Object.entries(numbers)) {
        await field.click()
        await field.press('Control+a')
        await field.pressSequentially(text)
        await lens.nextFrame()
        expect((await lens.vertices())[7]).toBe(value)
        await expect(field).toHaveValue(text)
        await field.press('Enter')
        await expect(field).toHaveValue(text)
        await field.blur()
        await expect(field).toHaveValue(String(value))
        await lens.button('Undo').click()
        await expect.poll(() => lens.vertices()).toEqual(before)
      }
      for (const text of refused) {
        await page.evaluate(copied => navigator.clipboard.writeText(copied), text)
        await field.press('Control+a')
        await field.press('Control+v')
        await expect(page.getByText(`Vertex 2 y: “${text}” `)).toBeVisible()
        await expect(field).toHaveValue(text)
        expect(await lens.vertices()).toEqual(before)
      }
      await field.press('Escape')
      await expect(field).toHaveValue(String(before[7]))
      await expect(page.getByText('Vertex 2 y:')).toBeHidden()
    })
})

test('arrow keys go up and down by one, as one step to undo, and not where nothing may be changed', async ({
  lens,
}) => {
  await lens.open()
  const before = await lens.vertices()
  const field = lens.field(4, 'x')
  await field.click()
  await field.press('Control+a')
  await field.pressSequentially('0,25')
  await field.press('ArrowUp')
  await field.press('ArrowUp')
  await field.press('ArrowDown')
  await expect.poll(async () => (await lens.vertices())[12]).toBe(1.25)
  await field.blur()
  await lens.button('Undo').click()
  await expect.poll(() => lens.vertices()).toEqual(before)
  await lens.element.evaluate(element => element.setAttribute('readonly', ''))
  await field.press('ArrowUp')
  await lens.nextFrame()
  expect(await lens.vertices()).toEqual(before)
})

test('keys undo and redo from anywhere, and move the vertex whose row is in use', async ({ lens, page }) => {
  await lens.open()

  await test.step('the keys for undo and redo work from anywhere, but not in the middle of typing', async () => {
    const first = await lens.vertices()
    await lens.field(1, 'x').fill('3')
    await lens.field(1, 'x').press('Enter')
    await lens.nextFrame()
    const second = await lens.vertices()
    await page.keyboard.press('Control+z')
    await expect.poll(() => lens.vertices()).toEqual(first)
    await expect(lens.field(1, 'x')).toHaveValue(String(first[3]))
    await page.keyboard.press('Control+Shift+z')
    await expect.poll(() => lens.vertices()).toEqual(second)
    await lens.field(1, 'x').blur()
    await page.keyboard.press('Control+z')
    await expect.poll(() => lens.vertices()).toEqual(first)
    await page.keyboard.press('Control+y')
    await expect.poll(() => lens.vertices()).toEqual(second)

    await lens.field(1, 'y').press('End')
    await lens.field(1, 'y').pressSequentially('9')
    await page.keyboard.press('Control+z')
    await lens.nextFrame()
    expect((await lens.vertices())[3]).toBe(3)
  })

  await test.step('the row with the focus, or else under the mouse, is the vertex that the picture’s keys move', async () => {
    const before = await lens.vertices()
    await lens.field(5, 'x').focus()
    await lens.nextFrame()
    await lens.scene.focus()
    await page.keyboard.press('ArrowRight')
    await lens.nextFrame()
    expect((await lens.vertices()).filter((_, i) => i < 15 || i > 17)).toEqual(
      before.filter((_, i) => i < 15 || i > 17),
    )
    expect(await lens.vertices()).not.toEqual(before)
    await lens.field(2, 'y').hover()
    await lens.nextFrame()
    await page.keyboard.press('ArrowRight')
    await lens.nextFrame()
    expect((await lens.vertices()).slice(6, 9)).not.toEqual(before.slice(6, 9))
  })
})
