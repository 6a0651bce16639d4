import { expect, type Lens, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const stateOf = (lens: Lens) => lens.element.evaluate(element => (element as Element).state)

const scrolls = (lens: Lens) =>
  lens.element.evaluate(element => ({
    page: document.documentElement.scrollTop,
    panels: element.shadowRoot?.querySelector('.side')?.scrollTop,
  }))

/** Vertices on the screen, in the element and in the reference cube; the selected one is last. */
const places = (lens: Lens) =>
  lens.element.locator('.scene-overlay .handle').evaluateAll(handles => {
    const boxes = handles.map(handle => handle.getBoundingClientRect())
    return boxes.flatMap(({ x, y }) => [x, y]).sort((a, b) => a - b)
  })

// Wide enough for the panels to scroll by themselves.
test.use({ viewport: { width: 960, height: 640 } })

test('a reload, and Back after another preset, return to the same place', async ({ lens, page }) => {
  await lens.open()
  await lens.field(6, 'z').fill('0.3000000000000000444')
  await lens.field(6, 'z').press('Enter')
  await lens.nextFrame()
  await lens.scene.focus()
  for (const key of ['d', 'd', 'w', '+', '+', 'r', '3']) await page.keyboard.press(key)
  await page.getByRole('application', { name: 'The reference cube' }).focus()
  await page.keyboard.press('ArrowLeft')
  await page.getByRole('button', { name: /^jacdet on/ }).click()
  for (const name of ['Inside', 'Algorithm 1, step by step']) await lens.button(name).click()
  await page.getByRole('slider', { name: 'Section at ζ' }).fill('0.83')
  for (const _ of Array(9)) await lens.button('Forward').click()
  // A row of the vertices that came under the mouse would be chosen.
  await page.mouse.move(0, 0)
  await page.locator('hex-lens .side').evaluate(side => side.scrollTo({ top: 777 }))
  await lens.nextFrame()
  const [state, scroll, picture, address] = [await stateOf(lens), await scrolls(lens), await places(lens), page.url()]
  expect(state).toMatchObject({
    preset: 'looks-fine',
    selectedVertex: 3,
    faceDisplay: 'inside',
    referenceShown: true,
    referenceCube: 'biunit',
    openPanels: ['inside', 'algorithm'],
    section: { axis: 2, value: 0.83 },
    following: { step: 9 },
  })
  expect(state.camera?.zoom).toBeGreaterThan(1.4)
  expect(state.referenceCamera?.direction).not.toEqual(state.camera?.direction)
  expect(state.vertices[20]).not.toBe(state.start[20])
  expect(scroll).toEqual({ page: 0, panels: 777 })

  await page.reload()
  await expect(page.getByText('10 of 26')).toBeVisible()
  await expect.poll(() => scrolls(lens)).toEqual(scroll)
  expect(await stateOf(lens)).toEqual(state)
  await expect(page.getByRole('slider', { name: 'Section at ζ' })).toHaveValue('0.83')
  const again = await places(lens)
  expect(again).toHaveLength(32)
  // The picture is kept to a millionth of the element's size.
  expect(Math.max(...again.map((x, i) => Math.abs(x - (picture[i] as number))))).toBeLessThan(0.1)
  await expect(lens.button('Undo')).toBeEnabled()

  await lens.preset.focus()
  await page.keyboard.press('u')
  await expect(lens.preset).toHaveValue('cube')
  await expect.poll(() => page.url()).not.toBe(address)
  await page.goBack()
  await expect.poll(() => page.url()).toBe(address)
  await lens.nextFrame()
  expect(await stateOf(lens)).toEqual(state)

  await page.setViewportSize({ width: 390, height: 700 }) // here the page scrolls, not the panels
  await lens.nextFrame()
  await page.evaluate(() => scrollTo({ top: 1500 }))
  // Layout above moves the place along, until nothing does.
  let down = 0
  await expect
    .poll(async () => {
      const before = down
      await lens.nextFrame()
      down = (await scrolls(lens)).page
      return down > 1000 && down === before
    })
    .toBe(true)
  await page.reload()
  await expect.poll(() => scrolls(lens)).toMatchObject({ page: down })
})

test('a state is data: set on another element it is the same there, and one that is none is refused', async ({
  lens,
  page,
}) => {
  await lens.open()
  const told = await page.evaluate(async () => {
    const lens = document.querySelector('hex-lens') as Element
    const first = lens.state
    const text = JSON.stringify({
      ...first,
      vertices: first.vertices.with(0, '-0'),
      openPanels: ['morph'],
      faceDisplay: 5,
    })
    const camera = { direction: [3, 0, 4], zoom: 2, pan: [0, 0, 0.5] }
    const other = document.createElement('hex-lens')
    other.views = 'all'
    other.state = { ...JSON.parse(text), camera }
    lens.parentElement?.append(other)
    const before = other.state
    while (!other.shadowRoot?.querySelector('[data-frames]')) await new Promise(requestAnimationFrame)
    const refusals: string[] = []
    lens.addEventListener('hex-error', event => refusals.push((event as CustomEvent).detail.code))
    for (const wrong of [{ ...first, version: 2 }, { ...first, faceDisplay: 9 }, 'x'])
      lens.state = wrong as typeof first
    return { before, after: other.state, minus: Object.is(other.vertices[0], -0), refusals, kept: lens.state, first }
  })
  expect(told.minus).toBe(true)
  expect(told.before.camera).toEqual({ direction: [3, 0, 4], zoom: 2, pan: [0, 0, 0.5] })
  expect(told.after).toEqual({ ...told.before, camera: { direction: [0.6, 0, 0.8], zoom: 2, pan: [0, 0, 0.5] } })
  expect(told.refusals).toEqual(['bad-state', 'bad-state', 'bad-state'])
  expect(told.kept).toEqual(told.first)
  await expect(page.locator('hex-lens').nth(1).getByRole('button', { name: 'Undo' })).toBeDisabled()
})
