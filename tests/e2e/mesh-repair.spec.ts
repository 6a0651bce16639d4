/** Repair on the page Mesh: a vertex is dragged, another put to its best place, the rest untangled; what is saved is valid for `check`. */
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Page } from '@playwright/test'
import { vertexReference } from '../../web/model/hexahedron'
import { unitCube } from '../unit/core-fixtures'
import { vtuOf } from '../unit/vtu-text'
import { expect, expectAxeFindsNothing, handleOf, inSchemesAndWidths, test } from './lens'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-mesh-repair-'))
test.afterAll(() => rmSync(folder, { recursive: true }))

test.use({ viewport: { width: 1280, height: 900 } })

/** Cells along an edge, and nodes. */
const CELLS = 4
const NODES = CELLS + 1
const nodeAt = (i: number, j: number, k: number) => 1 + i + NODES * (j + NODES * k)

/** To the right on the screen, as the lens first looks. */
const RIGHT = [Math.sin((58 * Math.PI) / 180), Math.cos((58 * Math.PI) / 180), 0]
const DRAGGED = nodeAt(1, 1, 1)
const PLACED = nodeAt(3, 3, 3)
const TANGLED = nodeAt(3, 1, 3)
const AWAY: Readonly<Record<number, readonly number[]>> = {
  [DRAGGED]: RIGHT.map(x => 1.25 * x),
  [PLACED]: [-1.5, -1.2, 1.4],
  [TANGLED]: [-1.3, 1.2, -1.4],
}

/** A grid in which one inner node is too far to the right, and two are somewhere else; no cell has two of them. */
function gridFile(): string {
  const lines = ['*HEADING', 'a grid', '*NODE, NSET=ALL']
  for (let k = 0; k < NODES; ++k)
    for (let j = 0; j < NODES; ++j)
      for (let i = 0; i < NODES; ++i) {
        const node = nodeAt(i, j, k)
        const by = AWAY[node] ?? [0, 0, 0]
        const place = [i, j, k].map((x, axis) => (x + (by[axis] as number)).toFixed(6))
        lines.push(`${String(node).padStart(6)}, ${place.join(',   ')}`)
      }
  lines.push('*ELEMENT, TYPE=C3D8, ELSET=EALL')
  for (let k = 0; k < CELLS; ++k)
    for (let j = 0; j < CELLS; ++j)
      for (let i = 0; i < CELLS; ++i) {
        const nodes = vertexReference.map(([x, y, z]) => nodeAt(i + x, j + y, k + z))
        lines.push(`${1 + i + CELLS * (j + CELLS * k)}, ${nodes.join(', ')}`)
      }
  return `${lines.join('\n')}\n*MATERIAL, NAME=STEEL\n** the rest stays as it is\n`
}

const headline = (page: Page) => page.locator('.overview .headline')
const moved = (page: Page) => page.locator('.moving .moved')
const invalidAround = (page: Page) => page.locator('hex-lens .surroundings .invalid')

async function invalidCount(page: Page): Promise<number> {
  const [, count] = /^(\d+) of 64/.exec((await headline(page).textContent()) ?? '') ?? []
  return count === undefined ? 0 : Number(count)
}

async function openGrid(page: Page): Promise<void> {
  const file = join(folder, 'grid.inp')
  writeFileSync(file, gridFile())
  await page.goto('mesh.html')
  await expect(headline(page)).toHaveText(/^12 of 7,168/)
  await page.locator('.overview input[type=file]').setInputFiles(file)
  await expect(headline(page)).toHaveText(/^\d+ of 64 hexahedra are invalid/)
}

async function choose(page: Page, id: number): Promise<void> {
  await page.getByLabel('Go to id').fill(String(id))
  await page.getByRole('button', { name: 'Go', exact: true }).click()
  await expect(page.locator('.one .which')).toHaveText(new RegExp(`^Cell ${id},`))
}

async function saved(page: Page, name: RegExp): Promise<string> {
  const menu = page.getByRole('region', { name: 'Take away' })
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    menu.getByRole('button', { name }).first().click(),
  ])
  const file = join(folder, download.suggestedFilename())
  await download.saveAs(file)
  return file
}

function asksBeforeLeaving(page: Page): Promise<boolean> {
  return page.evaluate(() => !window.dispatchEvent(new Event('beforeunload', { cancelable: true })))
}

function checkStatus(file: string): number | null {
  const script = fileURLToPath(new URL('../../tools/hexlens.mjs', import.meta.url))
  return spawnSync(process.execPath, [script, 'check', file], { encoding: 'utf8' }).status
}

test('a vertex is dragged, one put to its best place, the rest untangled; both files that are saved are valid', async ({
  lens,
  page,
}) => {
  await openGrid(page)
  const before = await invalidCount(page)
  expect(before).toBeGreaterThan(8)
  await choose(page, 2)
  await expect(lens.verdict).toHaveText(/^INVALID/)

  await test.step('dragged until its cells are valid; the neighbours and the rows follow', async () => {
    await expect(invalidAround(page)).toHaveAttribute('d', /^M/)
    const row = page.locator('.list .row.chosen .class')
    await expect(row).toHaveText('INVALID')
    const { x, y } = await handleOf(lens, 7)
    await page.mouse.move(x, y)
    await page.mouse.down()
    for (let way = 8; (await invalidAround(page).getAttribute('d')) !== ''; way += 8) {
      expect(way).toBeLessThan(600)
      await page.mouse.move(x - way, y)
      await lens.nextFrame()
    }
    // It is still in the hand: the list already has it, in its place.
    await expect(lens.verdict).toHaveText(/^VALID/)
    await expect(row).toHaveText('valid')
    expect(await invalidCount(page)).toBe(before)
    await page.mouse.up()
    await expect(moved(page)).toHaveText(/^1 vertex moved\./)
    await expect.poll(() => invalidCount(page)).toBeLessThan(before)
    await expect(page.locator('.overview .notes')).toContainText('1 vertex has been moved here.')
  })

  const after = await invalidCount(page)
  await test.step('undone and redone, also from the lens, which has no other steps', async () => {
    await page.getByRole('button', { name: 'Undo', exact: true }).click()
    await expect.poll(() => invalidCount(page)).toBe(before)
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await lens.scene.press('Control+Shift+z')
    await expect.poll(() => invalidCount(page)).toBe(after)
    await lens.scene.press('Control+z')
    await expect.poll(() => invalidCount(page)).toBe(before)
    await page.getByRole('button', { name: 'Redo', exact: true }).click()
    await expect.poll(() => invalidCount(page)).toBe(after)
  })

  await test.step('the boundary stays until it is freed; a vertex goes back to where it was', async () => {
    const first = await lens.vertices()
    await lens.scene.press('0')
    await lens.scene.press('ArrowRight')
    await expect(moved(page)).toContainText('Vertex 0 stays: it is on the boundary of the hexahedra.')
    expect(await lens.vertices()).toEqual(first)
    await page.getByLabel('Free the boundary').check()
    await lens.scene.press('ArrowRight')
    await expect(moved(page)).toHaveText(/^2 vertices moved\./)
    expect(await lens.vertices()).not.toEqual(first)
    await page.getByRole('button', { name: 'Vertex back' }).click()
    await expect(moved(page)).toHaveText(/^1 vertex moved\./)
    await expect.poll(() => lens.vertices()).toEqual(first)
    await page.getByLabel('Free the boundary').uncheck()
  })

  await test.step('another goes to its best place', async () => {
    await choose(page, 43)
    const place = page.locator('.one > .place')
    await place.getByText('Best place of a vertex').click()
    await place.getByRole('button', { name: 'Vertex 6, ' }).click()
    await expect(place).toContainText(
      /Best place of vertex 6: the least relative minimum of its 8 cells goes from −[\d.]+ to [01]/,
    )
    await expect(place).toContainText('No place is better, proved')
    await place.getByRole('button', { name: 'Move there' }).click()
    await expect(place).toContainText('Vertex 6 is at its best place')
    await expect(moved(page)).toHaveText(/^2 vertices moved\./)
    await expect(lens.verdict).toHaveText(/^VALID/)
    await expect.poll(() => invalidCount(page)).toBeLessThan(after)
  })

  const rest = await invalidCount(page)
  expect(rest).toBeGreaterThan(0)
  await test.step('the rest is untangled: said, shown, taken as one step', async () => {
    await page.getByRole('button', { name: 'Untangle' }).click()
    const panel = page.getByRole('region', { name: 'Untangle' })
    const margin = panel.getByLabel('Relative minima at least')
    await margin.fill('2')
    await panel.getByRole('button', { name: 'Untangle' }).click()
    await expect(panel).toContainText('The least relative minimum is a number from 0 to 1.')
    await margin.fill('0.1')
    const boundary = panel.getByLabel(/^The boundary/)
    await boundary.selectOption('moves within a distance')
    await panel.getByRole('button', { name: 'Untangle' }).click()
    await expect(panel).toContainText('The distance is a number above 0, in units of the mesh.')
    await boundary.selectOption('stays')
    await panel.getByRole('button', { name: 'Untangle' }).click()
    await expect(panel.locator('.result')).toHaveText(
      /of \d+ invalid cells would be valid\. .* on average .* at most\. All reach 0\.1\./,
    )
    expect(await invalidCount(page)).toBe(rest)
    await expectAxeFindsNothing(page)
    await inSchemesAndWidths(lens, async () => {})
    await panel.getByRole('button', { name: 'Take it' }).click()
    await expect(panel.locator('.result')).toHaveText(
      /^\d+ vert(?:ex has|ices have) moved: one step to undo\. All reach 0\.1\.$/,
    )
    await expect(headline(page)).toHaveText(/^All 64 hexahedra are valid/)
    await page.getByRole('button', { name: 'Undo', exact: true }).click()
    await expect.poll(() => invalidCount(page)).toBe(rest)
    await page.getByRole('button', { name: 'Redo', exact: true }).click()
    await expect(headline(page)).toHaveText(/^All 64 hexahedra are valid/)
  })

  await test.step('another mesh does not lose what is in no file', async () => {
    const said = (await moved(page).textContent()) as string
    await page.getByLabel('Examples').selectOption('Block to untangle')
    await expect(headline(page)).toHaveText(/^\d+ of 1,800 hexahedra are invalid/)
    await expect(page.locator('.overview .news')).toContainText(/^\s*\d+ moved vertices of grid\.inp are in no file\./)
    await page.getByRole('button', { name: 'Back to grid.inp' }).press('Enter')
    await expect(headline(page)).toHaveText(/^All 64 hexahedra are valid/)
    await expect(headline(page)).toBeFocused()
    await expect(page.locator('.overview .news')).toHaveCount(0)
    await expect(moved(page)).toHaveText(said)
    await page.getByRole('button', { name: 'Undo', exact: true }).click()
    await expect.poll(() => invalidCount(page)).toBe(rest)
    await page.getByRole('button', { name: 'Redo', exact: true }).click()
    await expect(headline(page)).toHaveText(/^All 64 hexahedra are valid/)
    expect(await asksBeforeLeaving(page)).toBe(true)
  })

  await test.step('saved: as VTU, and in its own format with all else as it was', async () => {
    await page.getByRole('button', { name: 'Take away' }).click()
    const vtu = await saved(page, /^VTU the mesh/)
    const own = await saved(page, /^Abaqus the file that was read/)
    expect([checkStatus(vtu), checkStatus(own)]).toEqual([0, 0])
    const [lines, now] = [gridFile(), readFileSync(own, 'utf8')].map(text => text.split('\n')) as [string[], string[]]
    expect(now.length).toBe(lines.length)
    const other = lines.filter((line, i) => line !== now[i]).map(line => Number.parseInt(line, 10))
    expect(other).toEqual(expect.arrayContaining([DRAGGED, PLACED, TANGLED]))
    const count = Number(/^\d+/.exec((await moved(page).textContent()) ?? '')?.[0])
    expect(other.length).toBe(count)
    expect(await asksBeforeLeaving(page)).toBe(false)
  })
})

test('examples to untangle; what is left and why; all of it by keys', async ({ lens, page }) => {
  await page.goto('mesh.html')
  await expect(headline(page)).toHaveText(/^12 of 7,168/)
  const button = page.getByRole('button', { name: 'Untangle' })
  const panel = page.getByRole('region', { name: 'Untangle' })
  await test.step('what is left, and why: each vertex leads to its cell', async () => {
    await button.press('Enter')
    await panel.getByLabel(/^The boundary/).selectOption('slides where it is planar')
    await panel.getByRole('button', { name: 'Untangle' }).press('Enter')
    await expect(panel.locator('.result')).toContainText(/cells? stays? below 0\.1, \d+ of them invalid: \d+ vert/)
    const held = panel.getByRole('listitem').first()
    await expect(held).toHaveText(/^\s*Vertex [0-7] of cell \d+: no /)
    await held.getByRole('button').press('Enter')
    const [, cell] = /of cell (\d+)/.exec((await held.textContent()) ?? '') ?? []
    await expect(page.locator('.one .which')).toHaveText(new RegExp(`^Cell ${cell}`))
    await expectAxeFindsNothing(page)
    const all = panel.getByRole('button', { name: /^The proofs of all \d+ vertices as a file$/ })
    const [download] = await Promise.all([page.waitForEvent('download'), all.press('Enter')])
    const [, count] = /^The proofs of all (\d+)/.exec((await all.textContent())?.trim() ?? '') ?? []
    await expect(panel.locator('.proofs')).toHaveText(
      new RegExp(`${download.suggestedFilename()} has certificates of \\d+ of ${count} vertices\\.`),
    )
  })
  await page.getByLabel('Examples').selectOption('Block to untangle')
  await expect(headline(page)).toHaveText(/^\d+ of 1,800 hexahedra are invalid/)
  await button.press('Enter')
  await panel.getByLabel(/^Where/).selectOption('The chosen cell and 1 ring around it')
  await panel.getByLabel('Relative minima at least').press('Enter')
  await expect(panel.locator('.result')).toHaveText(/would be valid/)
  await panel.getByRole('button', { name: 'Leave it' }).press('Enter')
  await expect(panel.locator('.result')).toHaveText('Left as it was: nothing has moved.')
  await expect(panel.getByRole('button', { name: 'Untangle' })).toBeFocused()
  await panel.getByRole('button', { name: 'Untangle' }).press('Enter')
  await expect(panel.getByRole('button', { name: 'Take it' })).toBeFocused()
  await panel.getByRole('button', { name: 'Take it' }).press('Enter')
  await expect(page.locator('.moving .moved')).toHaveText(/^\d+ vertices moved\./)
  await page.getByRole('button', { name: 'All back' }).press('Enter')
  await expect(page.locator('.moving .moved')).toHaveText(/^A vertex that is dragged moves in the mesh/)
  await panel.getByLabel(/^Where/).press('Escape')
  await expect(button).toBeFocused()

  await test.step('a mesh of several time steps is only shown', async () => {
    const steps = [1, 2].map(step => {
      const file = join(folder, `step_${step}.vtu`)
      writeFileSync(file, vtuOf([unitCube.map(x => step * x)]))
      return file
    })
    await page.locator('.overview input[type=file]').setInputFiles(steps)
    await expect(headline(page)).toHaveText('The hexahedron is valid.')
    const before = await lens.vertices()
    await lens.scene.press('ArrowRight')
    await expect(moved(page)).toContainText('A mesh of several time steps is only shown')
    expect(await lens.vertices()).toEqual(before)
    await button.press('Enter')
    await expect(panel).toContainText('open the file of one step alone to untangle it')
  })
})
