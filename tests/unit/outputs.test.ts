/** What the page Mesh writes of an open mesh: byte for byte what the command line writes, and whole where it takes many steps. */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it, test } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { histogramOf } from '../../web/mesh/histogram'
import { joined } from '../../web/mesh/join-meshes'
import type { Mesh } from '../../web/mesh/mesh'
import type { MeshCheck } from '../../web/mesh/mesh-check'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { verticesOf } from '../../web/mesh/vertices-of'
import { fileStem, sizeWords } from '../../web/pages/mesh/file-names'
import type { FormId } from '../../web/survey/survey-jobs'
import { Writing } from '../../web/survey/writing'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { checked, collapsedEdge, flat, invalidCorner, meshOf, mirroredCube, mshText, notFinite } from './mesh-fixtures'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-outputs-'))
afterAll(() => rmSync(folder, { recursive: true }))

const next = randomSource(21)
const elements = [
  ...[unitCube, invalidCorner, collapsedEdge, mirroredCube, notFinite, flat],
  ...Array.from({ length: 60 }, () => randomHexahedron(next, 0.3)),
]
const path = join(folder, 'a & "b" <c>.msh')
writeFileSync(path, mshText(elements, 101).replace('left, wall', 'left, "wall" <b>&\u202e\u001b[31m</b>'))

const LISTS = { minima: true, volumes: true, acceptedBy: true, exact: true }

function meshIn(file: string): Mesh {
  const [first, ...others] = readMeshes(fileOfBytes(file, new Uint8Array(readFileSync(file))))
  if (!first) throw new Error('There is no mesh.')
  return joined([first, ...others])
}

const opened = (mesh: Mesh) => checked(mesh, { worst: Infinity, lists: LISTS })

/** In steps of no time at all: one chunk each. */
function written(
  form: FormId,
  check: MeshCheck,
  name = path,
): { content: Buffer; steps: number; said: readonly string[] } {
  const writing = new Writing(form, { name, check, core })
  const parts: Uint8Array[] = []
  let last = 0
  for (;;) {
    const step = writing.run(0)
    if ('refused' in step) throw new Error(step.refused)
    expect(step.fraction).toBeGreaterThanOrEqual(last)
    expect(step.fraction).toBeLessThanOrEqual(1)
    last = step.fraction
    parts.push(step.bytes)
    if (step.isEnd) return { content: Buffer.concat(parts), steps: parts.length, said: step.said }
  }
}

async function cli(...args: string[]): Promise<string> {
  let output = ''
  await main(args, {
    input: (async function* () {})(),
    output: { write: text => (output += text) },
    errors: { write: () => {} },
  })
  return output
}

/** The file that an option of `check` writes. */
async function fileOf(option: string): Promise<Buffer> {
  const file = join(folder, 'out')
  await cli('check', option, file, path)
  return readFileSync(file)
}

describe('the page writes what the command line writes', () => {
  test.each([
    ['csv', '--csv'],
    ['html', '--html'],
  ] as const)('%s', async (form, option) => {
    const { content, steps } = written(form, await opened(meshIn(path)))
    expect(content.equals(await fileOf(option))).toBe(true)
    expect(steps).toBeGreaterThan(5)
  })

  it('json, with all that are invalid', async () => {
    const check = await opened(meshIn(path))
    expect(check.invalid).toBeGreaterThan(10)
    const { content } = written('json', check)
    expect(content.toString()).toBe(await cli('check', '--json', '--worst', String(check.invalid), path))
    const valid = await opened(meshOf([unitCube]))
    expect(JSON.parse(written('json', valid).content.toString())).toMatchObject({
      exit: 0,
      files: [{ worst: [{ index: 0 }] }],
    })
  })

  test.each(['abaqus', 'nastran', 'plain'] as const)('ids: %s', async kind => {
    const { content, said } = written(kind, await opened(meshIn(path)))
    expect([content.toString(), said]).toEqual([await cli('check', '--ids', kind, path), []])
  })

  it('certificates', async () => {
    const check = await opened(meshIn(path))
    const invalid = elements.map((_, cell) => cell).filter(cell => check.standingOf(cell) === 'invalid')
    const list = invalid.map(cell => {
      const vertices = verticesOf(check.mesh, cell)
      const points = [0, 1, 2, 3, 4, 5, 6, 7].map(v => vertices.slice(3 * v, 3 * v + 3))
      return { name: String(101 + cell), vertices: points }
    })
    const file = join(folder, 'list.json')
    writeFileSync(file, JSON.stringify(list))
    expect(written('certificates', check).content.toString()).toBe(await cli('certify', file))
    const none = await opened(meshOf([unitCube]))
    expect(written('certificates', none).content.toString()).toBe('[]\n')
  })
})

it('what has no ids is said, and what Nastran has no id for is refused in one sentence', async () => {
  const bare = await opened(meshOf([unitCube, mirroredCube], false))
  expect(written('plain', bare, 'part.vtu')).toMatchObject({
    said: ["part.vtu has no ids: these are indices from 0, in the file's order."],
    content: Buffer.from('1\n'),
  })
  const said = "part.vtu has no ids: these are numbers from 1, in the file's order."
  expect(written('abaqus', bare, 'part.vtu')).toMatchObject({
    said: [said],
    content: Buffer.from(`** ${said}\n*ELSET, ELSET=HEXLENS_INVALID\n2\n`),
  })
  expect(written('nastran', bare, 'part.vtu').content.toString()).toBe(`$ ${said}\nSET 1 = 2\n`)
  const named = await opened({ ...meshOf([mirroredCube]), ids: ['ring.1'] })
  expect(new Writing('nastran', { name: 'part.inp', check: named, core }).run(Infinity)).toEqual({
    refused: 'part.inp: Nastran has no id such as “ring.1”.',
  })
})

describe('the document to keep', () => {
  const documentOf = async (...args: string[]) => {
    const file = join(folder, 'out.html')
    await cli('check', '--html', file, ...args)
    return readFileSync(file, 'utf8')
  }

  it('has the sentence, the notes, the histogram, and ten cells drawn and in numbers', async () => {
    const html = await documentOf(path)
    const check = await opened(meshIn(path))
    expect(html).toMatch(new RegExp(`<h1 class="headline">${check.invalid} of 66 hexahedra are invalid\\. `))
    for (const note of check.notes) expect(html).toContain(note.replaceAll('<', '&lt;'))
    expect(html.match(/<svg class="hex"/g)).toHaveLength(10)
    expect(html.match(/<svg class="histogram"/g)).toHaveLength(1)
    const names = [...html.matchAll(/<h3>Cell (\d+), block /g)].map(([, id]) => Number(id))
    expect(names).toEqual([...check.worst.subarray(0, 10)].map(cell => 101 + cell))
  })

  it('is XML, refers to nothing outside itself, and has names from files as text alone', async () => {
    const html = await documentOf(path, join(folder, 'none <i>.msh'))
    expect(html).toContain('a &amp; &quot;b&quot; &lt;c&gt;.msh')
    expect(html).toContain('block left, &quot;wall&quot; &lt;b&gt;&amp;[31m&lt;/b&gt;')
    expect(html).toContain('none &lt;i&gt;.msh cannot be read: it is not there.')
    for (const character of ['\u202e', '\u001b', '<script', '<link', '<img', '@import', 'url(http', 'src=', 'href='])
      expect(html).not.toContain(character)
    expect([...html.matchAll(/url\(([^)]*)\)/g)].every(([, target]) => target === '#hex-hatch')).toBe(true)
    expect(html.match(/https?:[^"]*/g)).toEqual(['http://www.w3.org/1999/xhtml'])
    expect(wellFormed(html)).toEqual([])
    const ids = [...html.matchAll(/ id="([^"]*)"/g)].map(([, id]) => id)
    expect(new Set(ids).size).toBe(ids.length)
  })

  it('has every class that its drawings ask for, in both schemes', async () => {
    const html = await documentOf(path)
    const [light = '', dark = ''] = html.split('@media screen')
    const tiles = new Set([...html.matchAll(/class="(hex-[np]\d+-\d)"/g)].map(([, name]) => name as string))
    expect(tiles.size).toBeGreaterThan(20)
    expect([...tiles].filter(name => !light.includes(`.${name}{`) || !dark.includes(`.${name}{`))).toEqual([])
  })

  it('draws where jacdet is negative in negative colours alone, hatched', async () => {
    const mirrored = await documentOf(fileWith([mirroredCube]))
    expect(mirrored).toMatch(/class="hex-n/)
    expect(mirrored).toMatch(/<path class="hex-hatched"/)
    const cube = await documentOf(fileWith([unitCube]))
    expect(cube).not.toMatch(/<path class="hex-(n|hatched)/)
    // Three faces of a cube are seen, and of the others the tiles at the rim.
    expect(
      cube
        .match(/<path class="hex-p[^>]*>/g)
        ?.join('')
        .match(/Z/g),
    ).toHaveLength(3 * 12 * 12 + 3 * 23)
    expect(cube).toContain('<h1 class="headline">The hexahedron is valid.</h1>')
    expect(cube).toContain('The worst cell')
  })

  it('is there for what has no answer, no volume, or no hexahedra', async () => {
    const html = await documentOf(fileWith([unitCube, notFinite, flat]))
    expect(html).toContain('Unanswered. Vertex 6 y is not a finite number.')
    expect(html).toContain('none, the volume is 0')
    expect(html).toContain('2 have none: the volume is 0, or there is no answer.')
    const empty = join(folder, 'empty.msh')
    writeFileSync(empty, '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n')
    expect(await documentOf(empty)).toContain('There are no hexahedra of eight nodes.')
    expect(wellFormed(html)).toEqual([])
  })

  it('counts what check is told to count apart', async () => {
    const file = fileWith([unitCube, collapsedEdge])
    const html = await documentOf('--degenerate=skip', '--min-relative=0.5', file)
    expect(html).toContain('None of 2 hexahedra is known to be invalid.')
    expect(html).toContain('1 hexahedron has coincident vertices and count')
    expect(html).toContain('0 with a relative minimum below 0.5.')
    expect(html.match(/<svg class="hex"/g)).toHaveLength(1)
  })

  it('has the same percentiles whether all cells are in order or only ten', async () => {
    const mesh = meshIn(path)
    expect(histogramOf(await checked(mesh))).toEqual(histogramOf(await opened(mesh)))
  })
})

function fileWith(hexahedra: readonly (readonly number[])[]): string {
  const file = join(folder, 'some.msh')
  writeFileSync(file, mshText(hexahedra))
  return file
}

/** What is wrong with it as XML: tags that do not match, text with bare markup, attributes without quotes. */
function wellFormed(text: string): string[] {
  const wrong: string[] = []
  const open: string[] = []
  const body = text.replace(/^<!DOCTYPE html>\n/, '')
  for (const [part, tag, text] of body.matchAll(/<([^>]*)>|([^<]+)/g) as Iterable<[string, string?, string?]>) {
    if (tag === undefined) {
      if (/&(?!(?:amp|lt|gt|quot);)/.test(text ?? '')) wrong.push(part)
      continue
    }
    const [, slash, name = '', attributes = '', end] =
      /^(\/?)([a-zA-Z][a-zA-Z0-9]*)((?:\s+[a-zA-Z-]+="[^"<&]*(?:&(?:amp|lt|gt|quot);[^"<&]*)*")*)\s*(\/?)$/.exec(tag) ??
      []
    const keys = [...attributes.matchAll(/([a-zA-Z-]+)="/g)].map(match => match[1])
    if (name === '' || new Set(keys).size < keys.length) wrong.push(part)
    else if (slash === '/') {
      if (open.pop() !== name) wrong.push(part)
    } else if (end !== '/') open.push(name)
  }
  return [...wrong, ...open]
}

test.each([
  ['part.inp', 'part'],
  ['/a/b/Part 7 (new).msh.gz', 'Part-7-(new)'],
  ['x.y.vtu', 'x.y'],
  ['the text', 'the-text'],
  ['3 files', '3-files'],
  ['..\u202e<>:"|?*', 'mesh'],
  ['.vtu', 'mesh'],
])('a file taken of %j is called %j', (name, stem) => {
  expect(fileStem(name)).toBe(stem)
})

it('sizes are said shortly', () => {
  expect([0, 812, 1000, 40_123, 1_318_592, 2e9].map(sizeWords)).toEqual([
    '0 bytes',
    '812 bytes',
    '1 kB',
    '40.1 kB',
    '1.32 MB',
    '2 GB',
  ])
})
