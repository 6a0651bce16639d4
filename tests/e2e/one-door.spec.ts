/** Whoever sets the numbers that are already there changes nothing: no step to undo, no event, the same preset and start. */
import { drop, pasteAnywhere } from './input'
import { expect, type Lens, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

test.use({ permissions: ['clipboard-read', 'clipboard-write'], viewport: { width: 1280, height: 800 } })

const EVENTS = ['hex-input', 'hex-change']

/** Events are kept in `globalThis.told`. */
const listen = (lens: Lens) =>
  lens.element.evaluate((element, names) => {
    const told: string[] = []
    Object.assign(globalThis, { told })
    for (const name of names) element.addEventListener(name, () => told.push(name))
  }, EVENTS)

const told = (lens: Lens) => lens.page.evaluate(() => (globalThis as unknown as { told: string[] }).told)

const started = (lens: Lens) =>
  lens.element.evaluate(element => {
    const { preset, start } = (element as Element).state
    return { preset, start }
  })

const ways: Readonly<Record<string, (lens: Lens, vertices: readonly number[]) => Promise<unknown>>> = {
  'the attribute vertices': ({ element }, vertices) =>
    element.evaluate((lens, text) => lens.setAttribute('vertices', text), vertices.join(' ')),
  'the attribute preset': ({ element }) =>
    element.evaluate(lens => lens.setAttribute('preset', (lens as Element).preset ?? '')),
  'the property vertices': ({ element }) =>
    element.evaluate(lens => {
      const own = lens as Element
      own.vertices = own.vertices.slice()
    }),
  'the property preset': ({ element }) =>
    element.evaluate(lens => {
      const own = lens as Element
      own.preset = own.preset?.slice() ?? null
    }),
  'the property state': ({ element }) =>
    element.evaluate(lens => {
      const own = lens as Element
      own.state = JSON.parse(JSON.stringify(own.state))
    }),
  'the menu of presets': ({ preset }) => preset.selectOption('looks-fine'),
  'a link': ({ element }) =>
    element.evaluate(lens => {
      location.hash = new URL((lens as Element).permalink as string).hash
    }),
  'what is pasted': async ({ page, scene }, vertices) => {
    await scene.focus()
    await pasteAnywhere(page, vertices.join(' '))
    await expect(page.getByText('Read as points in text.').last()).toBeVisible()
  },
  'what is dropped': async ({ page, scene }, vertices) => {
    await drop(scene, { text: JSON.stringify(vertices) })
    await expect(page.getByText('Read as JSON.').last()).toBeVisible()
  },
  'a program that offers a text': async ({ element, page }, vertices) => {
    const points = Array.from({ length: 8 }, (_, v) => vertices.slice(3 * v, 3 * v + 3).join(' ')).join('; ')
    await element.evaluate((lens, text) => (lens as Element).offer(text), `P = [${points}]`)
    await expect(page.getByText('Read as MATLAB, cell P.').last()).toBeVisible()
  },
  'a field': async lens => {
    const field = lens.field(0, 'y')
    await field.fill(await field.inputValue())
    await field.blur()
  },
}

test('numbers that are already there are no change, whoever sets them', async ({ lens }) => {
  await lens.open()
  await listen(lens)
  const [bits, first] = [await lens.bits(), await started(lens)]
  const vertices = await lens.vertices()
  for (const [name, set] of Object.entries(ways))
    await test.step(name, async () => {
      await set(lens, vertices)
      await lens.nextFrame()
      expect(await lens.bits()).toEqual(bits)
      expect(await started(lens)).toEqual(first)
      expect(await told(lens)).toEqual([])
      await expect(lens.button('Undo')).toBeDisabled()
    })
  await lens.set(vertices.with(0, 7))
  expect(await told(lens)).toEqual(['hex-input']) // a program's own is not answered by hex-change
  await expect(lens.button('Undo')).toBeEnabled()
})
