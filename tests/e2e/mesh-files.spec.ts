/** Files that the page Mesh reads and writes: each export is read back by others and by `check`; one file ends another's workers. */
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import type { Page } from '@playwright/test'
import { MESH_FORMS } from '../../web/outputs/meshes/list'
import { checked } from '../unit/certificate-checker'
import { expect, expectAxeFindsNothing, test } from './lens'

const here = (name: string) => fileURLToPath(new URL(name, import.meta.url))
const python = here('../../build/python/bin/python')

const CELLS = 7168
const INVALID = [2547, 2951]

// A process may run tests of this file in two turns: each makes its own.
let folder: string
test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'hexlens-mesh-files-'))
})
test.afterAll(() => rmSync(folder, { recursive: true }))

test.use({ viewport: { width: 1280, height: 800 } })

const headline = (page: Page) => page.locator('.overview .headline')

async function openMesh(page: Page): Promise<void> {
  await page.goto('mesh.html')
  await expect(headline(page)).toHaveText(/^12 of 7,168 hexahedra are invalid/)
}

function output(command: string, ...args: string[]): string {
  const { error, stdout, stderr } = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 2 ** 27 })
  if (error || stdout === '') throw new Error(`${command} ${args.join(' ')}: ${error ?? stderr}`)
  return stdout
}

const hexlens = (...args: string[]) => output(process.execPath, here('../../tools/hexlens.mjs'), ...args)

interface Vtu {
  readonly points: number
  readonly cells: number
  readonly types: readonly number[]
  readonly arrays: Readonly<Record<string, readonly (number | null)[]>>
}

const vtkReads = (files: readonly string[]): Vtu[] => JSON.parse(output(python, here('read_vtk.py'), ...files))

test('what is taken away is read back: by VTK, by check, by the checker of certificates', async ({ page }) => {
  await openMesh(page)
  await expect(page.locator('.bar select').first()).toBeVisible()
  await page.getByRole('button', { name: 'Take away' }).click()
  const menu = page.getByRole('region', { name: 'Take away' })

  async function taken(section: string, name: string): Promise<string> {
    const button = menu
      .locator('div', { has: page.getByRole('heading', { name: section }) })
      .getByRole('button', { name: new RegExp(`^${name} `) })
    const [download] = await Promise.all([page.waitForEvent('download'), button.click()])
    const file = join(folder, download.suggestedFilename())
    await download.saveAs(file)
    await expect(menu.getByRole('status')).toContainText(download.suggestedFilename())
    return file
  }

  const csv = await taken('All cells', 'CSV')
  const [head = '', ...lines] = readFileSync(csv, 'utf8').trimEnd().split('\r\n')
  const columns = head.split(',')
  const column = (name: string) => lines.map(line => line.split(',')[columns.indexOf(name)] as string)
  const invalid = column('valid').flatMap((valid, i) => (valid === 'false' ? [i] : []))

  await test.step('CSV has all cells', () => {
    expect(lines).toHaveLength(CELLS)
    expect(invalid).toHaveLength(12)
    expect(invalid).toEqual(expect.arrayContaining(INVALID))
  })

  await test.step('the mesh and its invalid cells in all formats: VTK reads the same, and check; JSON is that of check', async () => {
    const files = { all: [] as string[], invalid: [] as string[] }
    for (const { name: format } of MESH_FORMS) {
      files.all.push(await taken('All cells', format))
      files.invalid.push(await taken('Invalid cells alone', format))
    }
    const ofVtk = files.all.filter((_, i) => /^vt/.test(MESH_FORMS[i]?.id ?? ''))
    expect(ofVtk).not.toEqual([])
    // Programs are started once for all files: to start one takes longer than to read a file.
    const [ofInvalid, ...read] = vtkReads([files.invalid[0] as string, ...ofVtk])
    for (const { cells, types, arrays } of read) {
      expect({ cells, types }).toEqual({ cells: CELLS, types: [12] })
      expect(arrays.valid).toEqual(column('valid').map(valid => (valid === 'true' ? 1 : 0)))
      for (const name of ['boundary_min', 'relative_min', 'volume'])
        expect(arrays[name]).toEqual(column(name).map(Number))
    }
    expect(ofInvalid?.cells).toBe(12)
    expect(ofInvalid?.arrays.index).toEqual(invalid)
    expect(ofInvalid?.arrays.relative_min).toEqual(invalid.map(cell => Number(column('relative_min')[cell])))

    const other = join(folder, 'again.csv')
    const said = hexlens('check', ...files.all, ...files.invalid, '--csv', other, '--json', '--worst', '12')
    const checkedFiles: { readonly file: string }[] = JSON.parse(said).files
    const again = readFileSync(other, 'utf8').trimEnd().split('\r\n').slice(1)
    // Formats with ids count from 1, and have blocks.
    const numbers = (line: string) =>
      line.split(',').filter((_, i) => !['file', 'id', 'block'].includes(columns[i] as string))
    for (const i of files.all.keys())
      expect(again.slice(CELLS * i, CELLS * (i + 1)).map(numbers)).toEqual(lines.map(numbers))
    expect(again).toHaveLength((CELLS + 12) * files.all.length)
    expect(checkedFiles.slice(files.all.length)).toMatchObject(
      files.invalid.map(() => ({ hexahedra: 12, invalid: 12 })),
    )

    const [own] = JSON.parse(readFileSync(await taken('All cells', 'JSON'), 'utf8')).files
    const byCheck = checkedFiles.find(({ file }) => file === join(folder, 'elbow-checked.vtu'))
    expect({ ...own, file: '', format: 'VTU' }).toEqual({ ...byCheck, file: '' })
  })

  await test.step('certificates are proved by who shares nothing with us', async () => {
    const file = await taken('Invalid cells alone', 'Certificates')
    const { status, output: said, errors } = checked(readFileSync(file, 'utf8'))
    expect({ status, errors }).toEqual({ status: 0, errors: '' })
    expect(said).toContain('12')
  })

  await test.step('ids in three languages', async () => {
    const ids = async (name: string) =>
      (readFileSync(await taken('Invalid cells alone', name), 'utf8').match(/\b\d+\b/g) ?? []).map(Number)
    expect(await ids('List')).toEqual(invalid)
    // In these two elements are numbered from 1.
    const numbered = invalid.map(cell => cell + 1)
    for (const name of ['ELSET', 'SET']) expect(await ids(name)).toEqual(expect.arrayContaining(numbered))
  })

  await test.step('the picture', async () => {
    const png = readFileSync(await taken('All cells', 'PNG'))
    expect(png.subarray(1, 4).toString()).toBe('PNG')
    expect(png.length).toBeGreaterThan(2000)
  })

  await test.step('the report needs nothing else', async () => {
    const file = await taken('All cells', 'Report')
    const report = await page.context().newPage()
    const asked: string[] = []
    report.on('request', request => asked.push(request.url()))
    await report.goto(pathToFileURL(file).href)
    await expect(report.locator('body')).toContainText('12 of 7,168 hexahedra are invalid.')
    await expect(report.locator('.histogram, .cell > svg')).toHaveCount(11)
    expect(asked).toEqual([pathToFileURL(file).href])
    await expectAxeFindsNothing(report)
    await report.close()
  })
})

/** A cube of cubes as Abaqus writes it, with enough cells for several workers. */
function abaqus(n: number): string {
  const lines = ['*NODE']
  const m = n + 1
  for (let i = 0; i < m ** 3; ++i)
    lines.push(`${i + 1}, ${i % m}., ${Math.floor(i / m) % m}., ${Math.floor(i / m / m)}.`)
  lines.push('*ELEMENT, TYPE=C3D8')
  let id = 0
  for (let z = 0; z < n; ++z)
    for (let y = 0; y < n; ++y)
      for (let x = 0; x < n; ++x) {
        const low = 1 + x + m * (y + m * z)
        const face = [low, low + 1, low + 1 + m, low + m]
        lines.push([++id, ...face, ...face.map(node => node + m * m)].join(', '))
      }
  return lines.join('\n')
}

test('another file ends the workers of the one before', async ({ page }) => {
  const big = join(folder, 'big.inp')
  writeFileSync(big, abaqus(60))
  await openMesh(page)
  const open = (file: string) => page.locator('.overview input[type=file]').setInputFiles(file)
  const openSmall = async () => {
    await open(here('../../../shared/meshes/made/vtk-raw-none.vtu'))
    await expect(headline(page)).toHaveText(/^10 of 16 hexahedra are invalid/)
  }
  /** Those of the mesh, and those that wait for the next one. */
  const settled = async () => {
    let count = -1
    await expect
      .poll(
        async () => {
          const before = count
          count = page.workers().length
          return before === count
        },
        { intervals: [1500] },
      )
      .toBe(true)
    return count
  }
  await openSmall()
  await settled()
  // A mesh that comes before the next worker has practised, as the first may, has no helper.
  await openSmall()
  const workers = await settled()
  await open(big)
  await expect(headline(page)).toHaveText('All 216,000 hexahedra are valid.')
  const ofBig = page.workers()
  await openSmall()
  expect(await settled()).toBeLessThanOrEqual(workers)
  await expect.poll(() => page.workers().filter(worker => ofBig.includes(worker)).length).toBeLessThan(ofBig.length)
})

test.describe('without wasm', () => {
  test.use({ expectedErrors: /Failed to load resource/ })

  test('its twin reads, decides and lists all the same', async ({ page }) => {
    await page.route('**/*.wasm*', route => route.abort())
    await openMesh(page)
    await expect(page.locator('.list .row:not(.head)').first()).toContainText('−2.2606')
    await page.locator('#condition').fill('not valid and corner_min > 0')
    await page.locator('#condition').press('Enter')
    await expect(page.locator('.go .count')).toHaveText(/^\s*4 of 7,168 cells\s*$/)
    await expect(page.locator('hex-lens .verdict .word')).toHaveText('INVALID')
  })
})
