/** Files in HDF5 on the page Mesh: their reader is loaded with the first of them, and the page says so. */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, expectAxeFindsNothing, test } from './lens'

const made = (name: string) => fileURLToPath(new URL(`../../../shared/meshes/made/${name}`, import.meta.url))
const READER = /hdf5_util/

test.use({ viewport: { width: 1240, height: 560 } })

test('the reader of HDF5 files is loaded with the first of them', async ({ page }) => {
  const loaded: string[] = []
  page.on('request', request => {
    if (READER.test(request.url())) loaded.push(request.url())
  })
  let letGo = () => {}
  const isHeld = new Promise<void>(resolve => {
    letGo = resolve
  })
  await page.context().route(READER, async route => {
    await isHeld
    await route.continue()
  })
  await page.goto('mesh.html')
  const headline = page.locator('.overview .headline')
  await expect(headline).toHaveText(/^12 of 7,168 hexahedra are invalid/)
  const files = page.locator('input[type=file]').first()
  await files.setInputFiles(made('gmsh-4.1-bin.msh'))
  await expect(headline).toHaveText(/^10 of 15 hexahedra are invalid/)
  expect(loaded).toEqual([])
  await files.setInputFiles(made('gmsh.cgns'))
  await expect(page.getByText('Loading the HDF5 reader, 1 MB')).toBeVisible()
  await expectAxeFindsNothing(page)
  letGo()
  await expect(page.locator('.overview')).toContainText('gmsh.cgns')
  await expect(headline).toHaveText(/^10 of 15 hexahedra are invalid/)
  expect(loaded).toHaveLength(1)
  const whole = readFileSync(made('meshio.med'))
  await files.setInputFiles({ name: 'cut.med', mimeType: '', buffer: whole.subarray(0, whole.length / 2) })
  await expect(page.locator('.news')).toContainText('it is cut off: of 27536 bytes it has 13768')
})

test('the time steps of one file have a slider', async ({ page }) => {
  const steps = (name: string) => fileURLToPath(new URL(`../unit/steps/${name}`, import.meta.url))
  await page.goto('mesh.html')
  const headline = page.locator('.overview .headline')
  const files = page.locator('input[type=file]').first()
  for (const name of ['moving.vtkhdf', 'classic.e']) {
    await files.setInputFiles(steps(name))
    await expect(page.getByText(`${name} has 4 time steps of one mesh.`)).toBeVisible()
    await expect(page.locator('.steps [role=status]')).toHaveText(
      /^\s*Step 3 \(t = 0\.5\) is the first with an invalid cell: cell [19]\.\s*$/,
    )
    await expect(headline).toHaveText(/^All 2 hexahedra are valid/)
    await page.getByRole('slider', { name: 'Time step' }).focus()
    for (let right = 2; right > 0; --right) await page.keyboard.press('ArrowRight')
    await expect(headline).toHaveText(/^1 of 2 hexahedra is invalid/)
    await expect(page.locator('.steps .now')).toContainText('Step 3 of 4, t = 0.5: 1 of 2 cells is invalid')
    await expect(page.getByRole('button', { name: 'Take them together' })).toHaveCount(0)
  }
  await expectAxeFindsNothing(page)
})
