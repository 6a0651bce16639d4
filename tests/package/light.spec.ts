/** `hexlens/light` as npm installs it: what it has works as in the whole element, and what it lacks is said. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { handleOf } from '../e2e/lens'
import { elsewhere, expect, test } from './elsewhere'

type Element = HTMLElementTagNameMap['hex-lens']

const page = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Light</title><link rel="icon" href="data:,">
  <script>
    globalThis.told = []
    for (const type of ['hex-input', 'hex-change', 'hex-verdict', 'hex-error'])
      addEventListener(type, event => told.push([type, event.detail?.message ?? null]), true)
  </script>
  <script type="module" src="node_modules/hexlens/dist/hexlens.light.js"></script></head>
  <body><main><h1>Light</h1><hex-lens preset="cube" style="height: 400px"></hex-lens></main></body></html>`

test('the light file has the scene and the verdict, by pointer, keyboard and attributes, and says what it lacks', async ({
  lens,
}) => {
  const told = () => lens.page.evaluate(() => (globalThis as unknown as { told: [string, string | null][] }).told)
  writeFileSync(join(elsewhere, 'light.html'), page)
  await lens.open('light.html')
  await expect(lens.verdict).toHaveText(/^VALID/)

  const { x, y } = await handleOf(lens, 6)
  await lens.page.mouse.move(x, y)
  await lens.page.mouse.down()
  await lens.page.mouse.move(x - 20, y + 15, { steps: 4 })
  await lens.page.mouse.up()
  const dragged = await lens.vertices()
  expect(dragged.slice(18, 21)).not.toEqual([1, 1, 1])
  await lens.page.keyboard.press('ArrowRight')
  expect(await lens.vertices()).not.toEqual(dragged)
  expect((await told()).map(([type]) => type)).toEqual(expect.arrayContaining(['hex-input', 'hex-change']))

  await lens.element.evaluate(element => element.setAttribute('preset', 'face-negative'))
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await lens.element.evaluate(element => (element as Element).undo())
  await expect(lens.verdict).toHaveText(/^VALID/)

  await lens.element.evaluate(element => element.setAttribute('views', 'scene verdict checks'))
  await expect(lens.page.getByRole('alert')).toContainText('“checks” is none of verdict, scene, all, none')
  await lens.element.evaluate(element => element.setAttribute('views', 'all'))
  await expect(lens.page.getByRole('alert')).not.toContainText('checks')
  await lens.element.evaluate(element => (element as Element).offer('0 0 0'))
  await expect(lens.page.getByRole('alert')).toContainText('the light file of Hexlens has no readers')
  expect((await told()).filter(([type]) => type === 'hex-error')).toHaveLength(2)

  const png = await lens.element.evaluate(async element => (await (element as Element).toPNG()).type)
  expect(png).toBe('image/png')
})
