/** `hexlens/hex-mesh` as npm installs it: a mesh by its address, what is said, listed, drawn and chosen, and what is left of it. */
import { copyFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import type { Locator, Page } from '@playwright/test'
import { snippetsOf } from './documentation'
import { elsewhere, expect, root, test } from './elsewhere'

type Mesh = HTMLElementTagNameMap['hex-mesh']
type Told = [type: string, detail: Record<string, unknown> | null]

const [head = '', body = ''] = snippetsOf('A mesh')

const page = (script: string, given: string) => `<!doctype html><html lang="en"><head><meta charset="utf-8">
  <meta name="viewport" content="width=device-width"><title>A mesh</title><link rel="icon" href="data:,">
  <style>:root { color-scheme: light dark }</style>
  <script>
    globalThis.told = []
    globalThis.contexts = []
    for (const type of ['hex-open', 'hex-ready', 'hex-pick', 'hex-error'])
      addEventListener(type, event => told.push([type, event.detail]), true)
    const { getContext } = HTMLCanvasElement.prototype
    HTMLCanvasElement.prototype.getContext = function (type, ...more) {
      const context = getContext.call(this, type, ...more)
      if (type === 'webgl2') contexts.push(context)
      return context
    }
    globalThis.workers = 0
    globalThis.Worker = class extends Worker {
      constructor(...given) { super(...given); workers++ }
      terminate() { workers--; super.terminate() }
    }
  </script>
  ${script.replace('src="', 'src="node_modules/hexlens/dist/')}</head>
  <body><main><h1>A mesh</h1>${given}</main></body></html>`

const told = (page: Page) => page.evaluate(() => (globalThis as unknown as { told: Told[] }).told)
const toldOf = async (page: Page, type: string) => (await told(page)).filter(([each]) => each === type)
const ready = (mesh: Locator) => mesh.evaluate(element => (element as Mesh).ready)

/** The middle of what is red in the picture, in pixels of the page. */
async function middleOfRed(page: Page, picture: Locator): Promise<{ x: number; y: number }> {
  const shot = (await picture.screenshot()).toString('base64')
  const box = await picture.boundingBox()
  const at = await page.evaluate(async text => {
    const image = new Image()
    image.src = `data:image/png;base64,${text}`
    await image.decode()
    const canvas = new OffscreenCanvas(image.width, image.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.drawImage(image, 0, 0)
    const { data } = context.getImageData(0, 0, image.width, image.height)
    let best = { x: 0, y: 0, run: 0 }
    for (let y = 0; y < image.height; ++y)
      for (let x = 0, run = 0; x < image.width; ++x) {
        const [r, g, b] = data.subarray(4 * (y * image.width + x)) as unknown as [number, number, number]
        run = r > g + 60 && r > b + 60 ? run + 1 : 0
        if (run > best.run) best = { x: x - run / 2, y, run }
      }
    return { x: best.x / image.width, y: best.y / image.height, run: best.run }
  }, shot)
  expect(at.run).toBeGreaterThan(3)
  return { x: (box?.x ?? 0) + at.x * (box?.width ?? 0), y: (box?.y ?? 0) + at.y * (box?.height ?? 0) }
}

test.describe('a mesh in a page', () => {
  test.use({ expectedErrors: /Failed to load resource/, pictureRatio: 1 })

  test('is said, listed, drawn and chosen from; what is not there is said; nothing is left of it', async ({
    page: tab,
  }) => {
    copyFileSync(join(root, '../shared/meshes/made/vtk-raw-none.vtu'), join(elsewhere, 'part.vtu'))
    writeFileSync(join(elsewhere, 'mesh.html'), page(head, body))
    await tab.goto('mesh.html')
    const mesh = tab.locator('hex-mesh')
    await ready(mesh)
    const summary = await mesh.evaluate(element => (element as Mesh).summary)
    expect(summary).toMatchObject({ name: 'part.vtu', format: 'VTU' })
    expect(summary?.invalid).toBeGreaterThan(0)
    const sentence = `${summary?.invalid} of ${summary?.hexahedra} hexahedra are invalid.`
    await expect(mesh.locator('.headline')).toContainText(sentence)
    expect((await told(tab)).map(([type]) => type)).toEqual(['hex-open', 'hex-ready'])
    await expect(mesh.getByText('of the 5,120 cells')).toBeHidden()
    expect((await new AxeBuilder({ page: tab }).analyze()).violations).toEqual([])

    // On a phone all buttons are above the list.
    const desktop = tab.viewportSize()
    await tab.setViewportSize({ width: 360, height: 740 })
    const bottomOfButtons = () =>
      mesh.locator('.bar button').evaluateAll(all => Math.max(...all.map(each => each.getBoundingClientRect().bottom)))
    const topOfList = () => mesh.locator('.list').evaluate(list => list.getBoundingClientRect().top)
    expect(await topOfList()).toBeGreaterThanOrEqual(await bottomOfButtons())
    await expect(mesh.locator('.notes')).not.toHaveAttribute('open')
    if (desktop) await tab.setViewportSize(desktop)

    // The list, the worst first, and a row of it.
    const rows = mesh.getByRole('grid', { name: 'Cells' }).getByRole('row')
    await expect(rows.nth(1)).toHaveText(/INVALID|inverted|collapsed/)
    await rows.nth(1).click()
    await expect.poll(() => toldOf(tab, 'hex-pick')).toHaveLength(1)
    const [[, byRow] = []] = await toldOf(tab, 'hex-pick')
    expect(byRow).toMatchObject({ valid: false })
    expect((byRow as { vertices: number[] }).vertices).toHaveLength(24)
    await expect(mesh.getByText(`Cell ${byRow?.id}, INVALID, `)).toBeVisible()

    // The picture: an invalid cell is red, and a click on it chooses it.
    await mesh.evaluate(element => (element as Mesh).pick(null))
    await mesh.getByRole('combobox').selectOption('invalid')
    expect(await mesh.getAttribute('mode')).toBe('invalid')
    const picture = mesh.getByRole('application')
    await expect.poll(() => middleOfRed(tab, picture).catch(() => null)).not.toBeNull()
    const { x, y } = await middleOfRed(tab, picture)
    await tab.mouse.click(x, y)
    await expect.poll(() => toldOf(tab, 'hex-pick')).toHaveLength(2)
    expect((await toldOf(tab, 'hex-pick'))[1]?.[1]).toMatchObject({ valid: false })

    // Keys; the wheel is the page's until the picture has the focus.
    await picture.focus()
    await tab.keyboard.press('n')
    await expect.poll(() => toldOf(tab, 'hex-pick')).toHaveLength(3)
    expect(await mesh.evaluate(element => element.matches(':state(ready):state(invalid)'))).toBe(true)

    // A program's mesh, and one that is not there: what is open stays, and a sentence says why.
    const opened = await mesh.evaluate(element =>
      (element as Mesh).open('0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1'),
    )
    expect(opened).toMatchObject({ hexahedra: 1, valid: 1, invalid: 0 })
    await mesh.evaluate(element => {
      ;(element as Mesh).src = 'none.vtu'
      ;(element as Mesh).mode = 'slice'
    })
    await expect(mesh.getByRole('alert')).toContainText(
      'none.vtu could not be fetched: the server answers 404 Not Found.',
    )
    await expect(mesh.getByRole('alert')).toContainText('“slice” is none of surface, invalid, neighbours')
    await expect(mesh.locator('.headline')).toContainText('The hexahedron is valid.')
    expect((await toldOf(tab, 'hex-error')).map(([, detail]) => detail?.code)).toEqual(['bad-mode', 'not-fetched'])
    expect((await new AxeBuilder({ page: tab }).analyze()).violations).toEqual([])

    const complaints: string[] = []
    tab.on('pageerror', error => complaints.push(error.message))

    // Mounted again and again, and removed while it reads: no worker and no context is left.
    const left = await mesh.evaluate(async element => {
      const parent = element.parentNode as HTMLElement
      element.remove()
      const counts = () => {
        const { workers, contexts } = globalThis as unknown as { workers: number; contexts: WebGL2RenderingContext[] }
        return { workers, contexts: contexts.filter(context => !context.isContextLost()).length }
      }
      for (let i = 0; i < 12; ++i) {
        const one = document.createElement('hex-mesh')
        one.src = 'part.vtu'
        parent.append(one)
        if (i % 2 === 0) await one.ready
        else await new Promise(requestAnimationFrame)
        one.remove()
      }
      await new Promise(resolve => setTimeout(resolve))
      return counts()
    })
    expect(left).toEqual({ workers: 0, contexts: 0 })
    expect(complaints).toEqual([])
  })
})

test.describe('without WebGL', () => {
  test('the sentence and the list are there, and the worker comes from another place, too', async ({
    page: tab,
    served,
  }) => {
    copyFileSync(join(root, '../shared/meshes/made/vtk-raw-none.vtu'), join(elsewhere, 'part.vtu'))
    const script = `<script>HTMLCanvasElement.prototype.getContext = () => null</script>
      <script type="module">
        import { setMeshWorker } from './node_modules/hexlens/dist/hexlens.hex-mesh.js'
        setMeshWorker('${served.replace('127.0.0.1', 'localhost')}/node_modules/hexlens/dist/hexlens.mesh-worker.js')
      </script>`
    writeFileSync(join(elsewhere, 'mesh-plain.html'), page(script, body))
    await tab.goto('mesh-plain.html')
    const mesh = tab.locator('hex-mesh')
    await ready(mesh)
    await expect(mesh.getByRole('alert')).toContainText('This browser gives no WebGL2, so there is no picture.')
    await expect(mesh.locator('.headline')).toContainText('hexahedra are invalid.')
    await mesh.getByRole('button', { name: 'Next' }).click()
    await expect.poll(() => toldOf(tab, 'hex-pick')).toHaveLength(1)
    expect(await mesh.getByRole('application').count()).toBe(0)
    expect((await new AxeBuilder({ page: tab }).analyze()).violations).toEqual([])
  })
})
