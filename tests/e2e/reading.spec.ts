/** Inputs as people paste and drop them: one of each kind, and the sentence about it. */
import { readdirSync, readFileSync } from 'node:fs'
import type { Locator, Page } from '@playwright/test'
import { type DroppedFile, drop, pasteAnywhere } from './input'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'

const shared = new URL('../../../shared/', import.meta.url)
const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const lexicographic = [0, 1, 3, 2, 4, 5, 7, 6].flatMap(v => cube.slice(3 * v, 3 * v + 3))

const given = (path: string): DroppedFile => ({
  name: path.slice(path.lastIndexOf('/') + 1),
  bytes: readFileSync(new URL(path, shared)),
})
const text = (path: string) => given(path).bytes.toString('utf8')
const pieces = readdirSync(new URL('meshes/made/pvtu/', shared)).map(name => given(`meshes/made/pvtu/${name}`))
const wholeOfPieces = pieces.filter(({ name }) => name.endsWith('.pvtu'))
const others = pieces.filter(({ name }) => !name.endsWith('.pvtu'))

interface Case {
  readonly what: string
  readonly give: (lens: Lens) => Promise<void>
  /** The sentence beside the verdict, or the refusal above the picture. */
  readonly says: string | RegExp
  readonly refused?: true
}

const files = (...dropped: readonly DroppedFile[]) => ({
  give: (lens: Lens) => drop(lens.scene, { files: dropped }),
})
const pasted = (content: string) => ({ give: (lens: Lens) => pasteAnywhere(lens.page, content) })

const cases: readonly Case[] = [
  { what: 'a log', ...pasted(text('pastes/04-libmesh-hex8.log')), says: /Read as libMesh/ },
  { what: 'quoted mail', ...pasted(text('pastes/77-markdown-quoted.inp')), says: /Read as Abaqus/ },
  {
    what: 'a text that is cut',
    ...pasted(text('pastes/80-gmsh-elided.msh')),
    says: /leaves something out: what is whole in it has been read/,
  },
  { what: 'two files in one paste', ...pasted(text('pastes/73-vtk-two-files.vtk')), says: /Read as VTK/ },
  { what: 'a gzipped file', ...files(given('meshes/made/vtk-ascii.vtu.gz')), says: /10 INVALID, 6 valid. Read as VTU/ },
  {
    what: 'a binary file',
    ...files(given('meshes/made/vtk-raw-none-f32.vtu')),
    says: /Not checked: .*1 wedge.*Float32.*is mirrored/,
  },
  { what: 'a format that is refused', ...files(given('meshes/made/gmsh.diff')), says: /Diffpack/, refused: true },
  {
    what: 'a file that is cut off',
    ...files(given('meshes/malformed/truncated-half-vtu-zlib.vtu')),
    says: /byte \d+: .* it is cut off\. The element is as it was/,
    refused: true,
  },
  {
    what: 'an index that is none',
    ...files(given('meshes/malformed/index-negative.vtu')),
    says: /^index-negative\.vtu/,
    refused: true,
  },
  { what: 'a file without its pieces', ...files(...wholeOfPieces), says: /it needs .* together/, refused: true },
  { what: 'the pieces, then', ...files(...others), says: /Read as PVTU|Read as VTU/ },
  { what: 'files that belong together', ...files(...pieces), says: /Read as PVTU|Read as VTU/ },
]

const readRegion = (page: Page) => page.getByRole('region', { name: 'What was read' })
const list = (page: Page) => page.getByRole('listbox', { name: 'Cells, worst first' })

function active(page: Page): Promise<Locator> {
  return list(page)
    .getAttribute('aria-activedescendant')
    .then(id => page.locator(`hex-lens #${id}`))
}

test.beforeEach(({ context }) => context.grantPermissions(['clipboard-read', 'clipboard-write']))

test('what is pasted and dropped is read, or refused in a sentence', async ({ lens, page }) => {
  await lens.open()
  for (const { what, give, says, refused } of cases)
    await test.step(what, async () => {
      const before = await lens.bits()
      await lens.scene.focus()
      await give(lens)
      if (!refused) await expect(readRegion(page)).toContainText(says)
      else {
        await expect(page.getByRole('alert').locator('span')).toHaveText(says)
        await expect(readRegion(page).getByText(/Read/)).toHaveCount(0)
        expect(await lens.bits()).toEqual(before)
      }
    })
})

test('where the order is not stated it says so, and one press takes the order that makes it valid', async ({
  lens,
  page,
}) => {
  await lens.open()
  await pasteAnywhere(page, lexicographic.join(' '))
  const read = readRegion(page)
  await expect(read).toContainText('Eight points taken in the order of the text.')
  await expect(read).toContainText('In the order “Lexicographic” it is valid.')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await lens.button('Use it').click()
  await expect(lens.verdict).toHaveText(/^VALID/)
  expect(await lens.vertices()).toEqual(cube)
  await expect(read.getByText('Taken in the order “Lexicographic”; Undo takes this back.')).toBeFocused()
  await lens.button('Undo').click()
  expect(await lens.vertices()).toEqual(lexicographic)
  await expect(lens.button('Use it')).toBeVisible()
  await expectAxeFindsNothing(page, '.reading')
  await lens.field(0, 'x').fill('-0.5')
  await lens.field(0, 'x').press('Enter')
  await expect(lens.button('Use it')).toBeHidden()
  await lens.button('Undo').click()
  await lens.button('Undo').click()
  await expect(lens.button('Undo')).toBeDisabled()
})

test('of 6,000 cells all are in the list, the worst first; one is found by its id and chosen', async ({
  lens,
  page,
}) => {
  await lens.open()
  await drop(lens.scene, { files: [given('pastes/44-calculix-6000.inp')] })
  await expect(readRegion(page)).toContainText('6000 hexahedra, 4 INVALID, 5996 valid. Read as Abaqus.')
  await expect(list(page)).toBeFocused()

  await test.step('by keyboard', async () => {
    const options = list(page).getByRole('option')
    await expect(options.first()).toHaveAttribute('aria-setsize', '6000')
    expect(await options.count()).toBeLessThan(30)
    expect((await options.allTextContents()).slice(0, 5).map(row => /INVALID|valid/.exec(row)?.[0])).toEqual([
      ...Array(4).fill('INVALID'),
      'valid',
    ])
    await page.keyboard.press('End')
    await expect(await active(page)).toHaveAttribute('aria-posinset', '6000')
    await expect(await active(page)).toBeInViewport()
    await page.getByRole('textbox', { name: 'Go to cell' }).fill('4711')
    await page.keyboard.press('Enter')
    await expect(await active(page)).toHaveAccessibleName(/^Cell 4711, valid, relative minimum .*, block Eall$/)
    await page.getByRole('textbox', { name: 'Go to cell' }).fill('x')
    await page.keyboard.press('Enter')
    await expect(page.getByText('There is no cell x.')).toBeVisible()
    await list(page).focus()
    await page.keyboard.press('Home')
    await page.keyboard.press('Enter')
    await expect(await active(page)).toHaveAttribute('aria-selected', 'true')
    await expect(lens.verdict).toHaveText(/^INVALID/)
  })

  await test.step('by pointer, as one step to undo', async () => {
    const before = await lens.bits()
    await list(page).getByRole('option').nth(4).click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    await lens.button('Undo').click()
    expect(await lens.bits()).toEqual(before)
  })

  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page, '.reading')
    await expectLargeTargets(readRegion(page).getByRole('button'))
  })
  await lens.button('Close the list').click()
  await expect(list(page)).toHaveCount(0)
})

test.describe('where the worker that reads', () => {
  test.use({ expectedErrors: /Failed to load resource|violates the following|policy: / })

  test('does not load, a sentence says so; one that is slow is cancelled', async ({ lens, page }) => {
    let release = () => {}
    const held = new Promise<void>(resolve => {
      release = resolve
    })
    await page.route(/assets\/worker-(?!file).*\.js/, async route => {
      await held
      await route.abort()
    })
    await lens.open()
    await pasteAnywhere(page, cube.join(' '))
    await expect(readRegion(page)).toContainText('Reading the text …')
    await lens.button('Cancel').click()
    await expect(readRegion(page).getByText(/Reading/)).toHaveCount(0)
    await pasteAnywhere(page, cube.join(' '))
    release()
    await expect(page.getByRole('alert')).toContainText(
      'Nothing was read: the worker that reads did not start: its script was not loaded',
    )
    await expect(readRegion(page).getByText(/Reading/)).toHaveCount(0)
  })

  test('is forbidden by a policy, a sentence says so', async ({ lens, page }) => {
    await page.route('./', async route => {
      const response = await route.fetch()
      const policy = "worker-src 'none'"
      await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } })
    })
    await lens.open()
    await pasteAnywhere(page, cube.join(' '))
    await expect(page.getByRole('alert')).toContainText('Nothing was read: the worker that reads did not start')
  })
})
