import type { Locator, Page } from '@playwright/test'
import type { Report } from '../../web/core/report'
import { formatJacdet, formatNumber } from '../../web/model/decimal'
import { faces, type Vec3, vertexReference } from '../../web/model/hexahedron'
import { presets, presetVertices } from '../../web/model/presets'
import { pointInCell } from '../../web/panels/face-maps/net'
import { colourScaleOf, type Rgb, rampColour, rampOf, rampPosition } from '../../web/scene/paint/colour-map'
import { core } from '../unit/core-fixtures'
import { expect, expectAxeFindsNothing, inSchemesAndWidths, type Lens, test } from './lens'

/** No two vertices, edges or faces are alike. */
const asymmetric = [
  0, 0.1, 0, 1.2, 0, 0.1, 0.9, 1.1, -0.2, 0.1, 0.8, 0.15, -0.1, 0, 1, 1, 0.2, 1.3, 1.4, 1, 0.9, 0, 1.3, 1.1,
]
const faceNegative = presetVertices(presets.find(({ id }) => id === 'face-negative') ?? presets[0])

const hex = (text: string): Rgb =>
  [1, 3, 5].map(at => Number.parseInt(text.slice(at, at + 2), 16) / 255) as unknown as Rgb
const light = rampOf({
  paper: hex('#fcfcfb'),
  ink: hex('#1c1e21'),
  negative: hex('#b2182b'),
  positive: hex('#2166ac'),
  neutral: hex('#eeeeeb'),
})

function analyzed(vertices: readonly number[]): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function jacdetAt(vertices: readonly number[], point: Vec3): number {
  const result = core.jacobian(vertices, point)
  if (!result.ok) throw new Error(result.error.message)
  return result.value.jacdet
}

test.use({ pictureRatio: 1 })

const panelOf = (page: Page) => page.getByRole('region', { name: 'Face maps' })
const mapOf = (page: Page, name: string) => page.getByRole('button', { name: `Face ${name},` })
const readoutOf = (page: Page) => panelOf(page).locator('.readout')

async function openMaps(lens: Lens, vertices: readonly number[]): Promise<void> {
  await lens.open()
  await lens.set(vertices)
  await lens.button('Face maps').click()
  await expect(mapOf(lens.page, '+ζ')).toBeVisible()
  await lens.nextFrame()
}

async function hover(map: Locator, x: number, y: number): Promise<void> {
  await map.scrollIntoViewIfNeeded()
  const { width, height } = (await map.boundingBox()) as { width: number; height: number }
  const inside = (way: number, size: number) => Math.max(1, Math.min(size - 1, way * size))
  await map.hover({ position: { x: inside(x, width), y: inside(y, height) } })
}

test('the scene draws the curve s*(t) of the chosen face while the panel is open', async ({ lens, page }) => {
  await openMaps(lens, faceNegative)
  const curve = lens.scene.locator('.least-curve').first()
  /** Its hidden pieces, then its seen ones. */
  const path = () => curve.locator('.line').evaluateAll(lines => lines.map(line => line.getAttribute('d')).join(''))
  await mapOf(page, '−ζ').press('Enter')
  await expect(curve).toBeVisible()
  const onFace = await path()
  expect(onFace.match(/L/g)?.length).toBeGreaterThan(10)

  await test.step('it goes through the minimizer in the middle of the face', async () => {
    const [x, y] = await lens.scene
      .locator('.minimizer .ring')
      .evaluate(ring => ['cx', 'cy'].map(name => Number(ring.getAttribute(name))))
    const distances = onFace
      .split(/[ML]/)
      .filter(Boolean)
      .map(point => point.split(' ').map(Number))
      .map(([px = 0, py = 0]) => Math.hypot(px - (x ?? 0), py - (y ?? 0)))
    expect(Math.min(...distances)).toBeLessThan(1)
  })

  await test.step('another face has another, a move of a vertex changes it, and without the panel there is none', async () => {
    await mapOf(page, '+ζ').press('Enter')
    await expect.poll(path).not.toBe(onFace)
    const onTop = await path()
    await lens.set(faceNegative.with(18, 1.25))
    await expect.poll(path).not.toBe(onTop)
    await lens.button('Face maps').click()
    await expect(curve).toBeHidden()
  })
})

test('looking at a point of a map, by pointer and by keys', async ({ lens, page }) => {
  await openMaps(lens, asymmetric)

  await test.step('pointing at a map looks at that point, leaving it looks away', async () => {
    const cross = panelOf(page).locator('.cross')
    await expect(cross).toBeHidden()
    await hover(mapOf(page, '+η'), 0.3, 0.4)
    await expect(cross).toBeVisible()
    const point = await readoutOf(page).locator('span').first().innerText()
    const [xi, eta, zeta] = point.slice(1, -1).split(', ').map(Number) as [number, number, number]
    expect(eta).toBe(1)
    expect(Math.abs(xi - 0.7)).toBeLessThan(0.02)
    expect(Math.abs(zeta - 0.6)).toBeLessThan(0.02)
    await expect(readoutOf(page)).toContainText(`J = ${formatJacdet(jacdetAt(asymmetric, [xi, eta, zeta]), 0, 'unit')}`)
    await page.getByRole('button', { name: /\[0,1\]/ }).hover()
    await expect(cross).toBeHidden()
    await expect(readoutOf(page)).toContainText('Point at a map')
  })

  await test.step('every map has at its corners the jacdets of its own vertices', async () => {
    const report = analyzed(asymmetric)
    for (const [face, { name, vertices }] of faces.entries()) {
      const map = mapOf(page, name)
      await expect(map).toHaveAccessibleName(`Face ${name}, vertices ${vertices.toSorted().join(', ')}`)
      for (const [x, y] of [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ] as const) {
        const vertex = vertexReference.findIndex(point => point.join() === pointInCell(face, x, y).join())
        const value = report.candidates.find(({ kind, id }) => kind === 'vertex' && id === vertex)?.value as number
        await hover(map, x, y)
        await expect(readoutOf(page)).toContainText(`J = ${formatJacdet(value, 0, 'unit')}`)
        const minimum = vertex === report.minimizer.id && report.minimizer.kind === 'vertex' ? ', the minimum' : ''
        await expect(page.getByRole('tooltip')).toHaveText(
          `Vertex ${vertex}: J = ${formatJacdet(value, 0, 'unit')}${minimum}`,
        )
      }
    }
  })

  await test.step('with keys the point moves over the face, Escape takes it away, Enter selects the face', async () => {
    const map = mapOf(page, '−ζ')
    await map.focus()
    await expect(map).toHaveAttribute('aria-pressed', 'false')
    await page.keyboard.press('ArrowRight')
    await expect(readoutOf(page)).toContainText('(9/16, 1/2, 0)')
    await page.keyboard.press('Shift+ArrowDown')
    await expect(readoutOf(page)).toContainText('(9/16, 3/4, 0)')
    for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowLeft')
    await expect(readoutOf(page)).toContainText('(0, 3/4, 0)')
    await expect(readoutOf(page)).toHaveAttribute('aria-live', 'polite')
    await page.keyboard.press('Escape')
    await expect(readoutOf(page)).toContainText('Point at a map')
    await page.keyboard.press('Enter')
    await expect(map).toHaveAttribute('aria-pressed', 'true')
    await expect(mapOf(page, '−ξ')).toHaveAttribute('aria-pressed', 'false')
    await expect(page.getByRole('heading', { name: 'Quartic of face −ζ' })).toBeVisible()
    expect(await lens.vertices()).toEqual(asymmetric)
  })
})

test('the maps have the colours and candidates of jacdet, the quartics their roots', async ({ lens, page }) => {
  await openMaps(lens, faceNegative)

  await test.step('the maps have the colours of jacdet, with lines and hatch over them', async () => {
    const report = analyzed(faceNegative)
    const scale = colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
    for (const [face, { name }] of faces.entries()) {
      const { size, pixels } = await mapOf(page, name)
        .locator('canvas')
        .evaluate(element => {
          const canvas = element as HTMLCanvasElement
          const context = canvas.getContext('2d') as CanvasRenderingContext2D
          return { size: canvas.width, pixels: [...context.getImageData(0, 0, canvas.width, canvas.height).data] }
        })
      let [positive, agreeing, negative, reddish] = [0, 0, 0, 0]
      for (let y = 0; y < size; y += 5) {
        for (let x = 0; x < size; x += 5) {
          const at = 4 * (y * size + x)
          const seen = [0, 1, 2].map(c => (pixels[at + c] as number) / 255) as unknown as Rgb
          const value = jacdetAt(faceNegative, pointInCell(face, (x + 0.5) / size, (y + 0.5) / size))
          const colour = rampColour(light, rampPosition(scale, value))
          if (value > 0) {
            positive++
            if (Math.max(...colour.map((c, i) => Math.abs(c - (seen[i] as number)))) < 0.01) agreeing++
          } else if (rampPosition(scale, value) < -0.3) {
            negative++
            if (seen[0] > seen[2]) reddish++
          }
        }
      }
      expect(agreeing).toBeGreaterThanOrEqual(0.5 * positive)
      expect(reddish).toBe(negative)
    }
  })

  await test.step('candidates are told on hover and, one after the other, by keys', async () => {
    const report = analyzed(faceNegative)
    const { minimizer, candidates } = report
    expect(minimizer.kind).toBe('face')
    const { name } = faces[minimizer.id] as (typeof faces)[number]
    const words = `Face ${name}: J = ${formatJacdet(minimizer.value, 0, 'unit')}, the minimum`
    await page.keyboard.press('Tab')
    const group = panelOf(page).getByRole('group', { name: 'Candidates for the minimum' })
    await expect(group.getByRole('img')).toHaveCount(candidates.length)
    await group.getByRole('img', { name: 'Vertex 0' }).focus()
    await expect(page.getByRole('tooltip')).toHaveText(
      `Vertex 0: J = ${formatJacdet(candidates[0]?.value ?? 0, 0, 'unit')}`,
    )
    const index = candidates.findIndex(({ kind, id }) => kind === 'face' && id === minimizer.id)
    for (let i = 0; i < index; i++) await page.keyboard.press('ArrowRight')
    await expect(group.getByRole('img', { name: words })).toBeFocused()
    await expect(page.getByRole('tooltip')).toHaveText(words)
    await page.keyboard.press('Escape')
    await expect(page.getByRole('tooltip')).toBeHidden()
  })

  await test.step('the plots share one t, by pointer and by keys, which the map marks', async () => {
    const face = analyzed(faceNegative).minimizer.id
    await mapOf(page, (faces[face] as (typeof faces)[number]).name).click()
    const slider = panelOf(page).getByRole('slider')
    await slider.focus()
    await expect(slider).toHaveAttribute('aria-valuetext', 'no t chosen')
    await page.keyboard.press('ArrowRight')
    await expect(slider).toHaveAttribute('aria-valuenow', '0.5')
    await page.keyboard.press('ArrowRight')
    await expect(slider).toHaveAttribute('aria-valuetext', /^t\s=\s0.5625, P\s=\s.+, D\s=\s.+, a\s=\s.+, s\*\s=\s/)
    await expect(panelOf(page).locator('.cross')).toBeVisible()
    await expect(readoutOf(page)).toContainText('9/16')
    await page.keyboard.press('Escape')
    await expect(panelOf(page).locator('.cross')).toBeHidden()
    const plot = slider.locator('svg').nth(2)
    await plot.scrollIntoViewIfNeeded()
    const { width } = (await plot.boundingBox()) as { width: number }
    await plot.hover({ position: { x: width / 4, y: 30 } })
    const t = Number(await slider.getAttribute('aria-valuenow'))
    expect(Math.abs(t - 0.25)).toBeLessThan(0.02)
  })

  await test.step('each face says its bound and what settles it, the quartic what became of its roots', async () => {
    for (const vertices of [faceNegative, asymmetric]) {
      const report = analyzed(vertices)
      await lens.set(vertices)
      const rows = page.getByRole('table', { name: 'What settles each face' }).locator('tbody tr')
      const by = (bound: boolean) => (bound ? 'bound' : 'quartic')
      for (const {
        id,
        lowerBound,
        runningMinimum,
        skippedByValidityRule,
        skippedByMinimumRule,
        roots,
      } of report.faces) {
        const { name } = faces[id] as (typeof faces)[number]
        await expect(rows.nth(id).locator('th, td')).toHaveText([
          name,
          formatJacdet(lowerBound, 0, 'unit'),
          formatJacdet(runningMinimum, 0, 'unit'),
          by(skippedByValidityRule),
          by(skippedByMinimumRule),
        ])
        await mapOf(page, name).focus()
        await page.keyboard.press('Enter')
        await expect(page.getByRole('heading', { name: `Quartic of face ${name}` })).toBeVisible()
        const fates = roots.map(({ t, s, fate }) =>
          fate === 'kept'
            ? new RegExp(`^t = ${formatNumber(t)}: kept, a = .* > 0 and s\\* = ${formatNumber(s as number)} inside`)
            : new RegExp(`^t = ${formatNumber(t)}: dropped, ${fate === 's-outside' ? 's\\* = ' : 'a = .* ≤ 0'}`),
        )
        await expect(panelOf(page).getByRole('listitem')).toHaveText(fates)
      }
    }
  })
})

test('nothing is painted while nothing changes, and coarsely while a gesture runs', async ({ lens, page }) => {
  await page.addInitScript(() => {
    const painted = { count: 0 }
    Object.assign(globalThis, { painted })
    const put = CanvasRenderingContext2D.prototype.putImageData
    CanvasRenderingContext2D.prototype.putImageData = function (
      this: CanvasRenderingContext2D,
      ...given: Parameters<typeof put>
    ) {
      painted.count++
      put.apply(this, given)
    } as typeof put
  })
  const painted = () => page.evaluate(() => (globalThis as unknown as { painted: { count: number } }).painted.count)
  await openMaps(lens, asymmetric)
  const before = await painted()
  expect(before).toBeGreaterThanOrEqual(6)
  await hover(mapOf(page, '+ξ'), 0.5, 0.5)
  await mapOf(page, '+ξ').click()
  await lens.nextFrame()
  expect(await painted()).toBe(before)
  const size = () =>
    mapOf(page, '+ξ')
      .locator('canvas')
      .evaluate(canvas => (canvas as HTMLCanvasElement).width)
  const sharp = await size()
  await lens.field(6, 'z').fill('1')
  await lens.nextFrame()
  expect(await size()).toBe(Math.min(sharp, 64))
  await lens.field(6, 'z').blur()
  await lens.nextFrame()
  expect(await size()).toBe(sharp)
})

test('axe finds nothing in the open maps, which fit', async ({ lens, page }) => {
  await openMaps(lens, faceNegative)
  await mapOf(page, '−ζ').click()
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-face-maps'))
})
