/** `<hex-mesh>` without a page: its attributes, what it fetches, and what the manifest says of it. */
import { readFileSync } from 'node:fs'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { HexLensError } from '../../web/element/hex-lens-error'
import { fetchedFile } from '../../web/mesh-element/fetched-file'
import { HexMesh } from '../../web/mesh-element/hex-mesh'
import { inputOf, MESH_ATTRIBUTES, MODES, readMode, readTheme } from '../../web/mesh-element/mesh-attributes'
import { MeshProblem } from '../../web/mesh-element/problem'

describe('an attribute', () => {
  it('has a value without being there, and one for each of its words', () => {
    expect([readMode(null), readTheme(null)]).toEqual(['surface', 'auto'])
    expect(MODES.map(mode => readMode(` ${mode} `))).toEqual(MODES)
    expect(readTheme('dark')).toBe('dark')
  })

  it('is refused in a sentence that names what there is', () => {
    expect(() => readMode('slice')).toThrow(HexLensError)
    expect(() => readMode('slice')).toThrow('mode is not understood: “slice” is none of surface, invalid, neighbours.')
    expect(() => readTheme('')).toThrow('theme is not understood')
  })
})

it('what is given to be opened is a text or files', () => {
  const file = new File(['0 0 0'], 'a.txt')
  expect(inputOf('0 0 0')).toEqual({ text: '0 0 0' })
  expect(inputOf(file)).toEqual({ files: [file] })
  expect(inputOf([file, file])).toEqual({ files: [file, file] })
  for (const given of [null, undefined, 7, {}, [], [file, 'b'], [null], new Date()]) expect(inputOf(given)).toBeNull()
})

describe('what is fetched', () => {
  const fetch = vi.fn<typeof globalThis.fetch>()
  const fractions: number[] = []
  const options = (most: number) => ({
    signal: new AbortController().signal,
    onProgress: (fraction: number) => void fractions.push(fraction),
    most,
  })
  const refusalOf = async (source: string, most = 100) => {
    const reason = await fetchedFile(source, options(most)).catch(reason => reason)
    expect(reason).toBeInstanceOf(MeshProblem)
    return [reason.code, reason.sentence()]
  }

  beforeEach(() => {
    vi.stubGlobal('fetch', fetch)
    vi.stubGlobal('document', { baseURI: 'https://example.org/docs/page.html' })
    fractions.length = 0
  })
  afterEach(() => vi.unstubAllGlobals())

  it('is a file of the name at the end of the address, which is relative to the page', async () => {
    fetch.mockResolvedValueOnce(new Response('12345', { headers: { 'content-length': '5' } }))
    const file = await fetchedFile('../meshes/a%20part.vtu?v=2', options(5))
    expect(String(fetch.mock.lastCall?.[0])).toBe('https://example.org/meshes/a%20part.vtu?v=2')
    expect([file.name, await file.text(), fractions]).toEqual(['a part.vtu', '12345', [1]])
  })

  it('is refused in a sentence if the server does, if nothing comes, or if it is no address', async () => {
    fetch.mockResolvedValueOnce(new Response('', { status: 404, statusText: 'Not Found' }))
    expect(await refusalOf('part.vtu')).toEqual([
      'not-fetched',
      'part.vtu could not be fetched: the server answers 404 Not Found.',
    ])
    fetch.mockRejectedValueOnce(new TypeError('Failed to fetch'))
    expect((await refusalOf('https://other.example/part.vtu'))[1]).toMatch(/^part\.vtu could not be fetched: .*CORS/)
    expect(await refusalOf('http://')).toEqual(['not-fetched', 'http:// could not be fetched: it is not an address.'])
  })

  it('is refused if it ends too early', async () => {
    const broken = new ReadableStream({ pull: controller => controller.error(new TypeError('network error')) })
    fetch.mockResolvedValueOnce(new Response(broken))
    expect((await refusalOf('part.vtu'))[1]).toContain('the connection or the memory ended before the file')
  })

  it('is refused if it is too large, be that said before or not', async () => {
    const most = 2 ** 20
    const sentence = ['too-large', 'part.vtu is larger than 1 MB, the most that is fetched with a page.']
    fetch.mockResolvedValueOnce(new Response('', { headers: { 'content-length': String(most + 1) } }))
    expect(await refusalOf('part.vtu', most)).toEqual(sentence)
    fetch.mockResolvedValueOnce(new Response(new Uint8Array(most + 1)))
    expect(await refusalOf('part.vtu', most)).toEqual(sentence)
  })

  it('is given up with the reason of the signal', async () => {
    const ended = new AbortController()
    ended.abort(new Error('removed'))
    fetch.mockRejectedValueOnce(new DOMException('aborted', 'AbortError'))
    await expect(fetchedFile('part.vtu', { ...options(9), signal: ended.signal })).rejects.toThrow('removed')
  })
})

describe('the manifest', () => {
  const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')
  const [element] = JSON.parse(read('custom-elements.json')).modules[1].declarations
  const names = (key: string) => (element[key] as { name: string }[]).map(({ name }) => name).sort()

  it('has the attributes that are observed, and members that are there', () => {
    expect(names('attributes')).toEqual([...MESH_ATTRIBUTES].sort())
    for (const { name, kind, readonly = false } of element.members) {
      const { get, set, value } = Object.getOwnPropertyDescriptor(HexMesh.prototype, name) ?? {}
      if (kind === 'method') expect([name, typeof value]).toEqual([name, 'function'])
      else expect([name, typeof get, set === undefined]).toEqual([name, 'function', readonly])
    }
  })

  it('has the events that are told, and the custom properties and parts of the tree', () => {
    const told = [...read('web/mesh-element/hex-mesh.ts').matchAll(/#tell\('(hex-\w+)'/g)].map(([, name]) => name)
    expect([...new Set(told)].sort()).toEqual(names('events'))
    const used = [...read('web/mesh-element/hex-mesh.css').matchAll(/--hl-[\w-]+/g)].map(([name]) => name)
    expect([...new Set(used)].sort()).toEqual(names('cssProperties'))
    const tree = read('web/mesh-element/mesh-view.ts') + read('web/mesh-element/mesh-stage.ts')
    const parts = [...tree.matchAll(/part(?:\.add\('|=")(\w+)/g)].map(([, name]) => name)
    expect([...new Set(parts)].sort()).toEqual(names('cssParts'))
  })
})
