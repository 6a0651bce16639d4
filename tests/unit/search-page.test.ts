/** The form of a search in the address, and what is kept in a browser's storage, whatever that does. */
import { afterEach, describe, expect, it, vi } from 'vitest'
import { readHexahedron } from '../../web/cli/read-hexahedra'
import { parseQuery } from '../../web/pages/search/engine/query'
import { Tally } from '../../web/pages/search/engine/tally'
import {
  decodeForm,
  encodeForm,
  type FormState,
  formOf,
  kinds,
  queryOf,
  withField,
} from '../../web/pages/search/form-state'
import { exported, KeptElements } from '../../web/pages/search/kept'
import {
  MOST_SEARCHES,
  SearchKeeper,
  type SearchRecord,
  type SearchWork,
  searchOf,
  withSearch,
} from '../../web/pages/search/kept-searches'
import { LiveRegion } from '../../web/pages/search/live-region'
import { entry, unitCube } from './core-fixtures'
import { readText, verticesOf } from './mesh-expectations'

const decoded = (query: string) => decodeForm(new URLSearchParams(query))

describe('the form', () => {
  it('of every kind is a query, and comes back from a short address', () => {
    for (const kind of kinds) {
      const form = formOf(kind)
      expect(parseQuery(queryOf(form)).ok, kind.id).toBe(true)
      expect(String(encodeForm(form))).toBe(`find=${kind.id}`)
      expect(decoded(String(encodeForm(form)))).toEqual({ form, problems: [] })
    }
    expect(decoded('').form).toEqual(formOf(entry(kinds, 0)))
  })

  it('comes back as it was typed, what is no number too', () => {
    const changes: [keyof FormState, string][] = [
      ['property', 'centre > 1/4 and corner_min != 0'],
      ['measure', 'centre & more'],
      ['law', 'box'],
      ['least', '-2.5'],
      ['greatest', 'two'],
      ['grid', 'integers'],
      ['symmetry', 'third-turn'],
      ['moved', '6'],
      ['seed', '4294967295'],
    ]
    let form = formOf(entry(kinds, 0))
    for (const [name, value] of changes) {
      form = withField(form, name, value)
      expect(decoded(String(encodeForm(form)))).toEqual({ form, problems: [] })
    }
    expect(form.find).toBe('own')
    const query = parseQuery(queryOf(form))
    expect(query.ok ? [] : query.error.map(({ field }) => field)).toEqual(['measure', 'distribution'])
    expect(parseQuery(queryOf({ ...form, greatest: '−1', least: ' -3 ', measure: 'centre' })).ok).toBe(true)
    expect(queryOf({ ...form, seed: '' }).seed).toBeNaN()
  })

  it('says what of an address it does not understand, and takes the rest', () => {
    const { form, problems } = decoded('find=treasure&symmetry=sevenfold&grid=constructor&seed=9')
    expect(problems.length).toBe(3)
    for (const text of ['treasure', 'sevenfold', 'constructor']) expect(problems.join(' ')).toContain(`“${text}”`)
    expect(form).toEqual(formOf(entry(kinds, 0), '9'))
  })

  it('of another kind keeps the seed, and a changed measure the kind', () => {
    const form = withField(formOf(entry(kinds, 0), '12'), 'find', 'gap')
    expect(form).toEqual(
      formOf(
        entry(
          kinds.filter(({ id }) => id === 'gap'),
          0,
        ),
        '12',
      ),
    )
    expect(withField(form, 'measure', 'centre').find).toBe('gap')
  })
})

class MemoryStorage {
  readonly items = new Map<string, string>()
  getItem(key: string): string | null {
    return this.items.get(key) ?? null
  }
  setItem(key: string, value: string): void {
    this.items.set(key, value)
  }
  removeItem(key: string): void {
    this.items.delete(key)
  }
}

const element = (name: string, x: number) => ({ name, vertices: unitCube.with(0, x), property: 'not valid' })
const names = (kept: KeptElements) => kept.elements.map(({ name }) => name)

describe('what is kept', () => {
  it('is there for the next page, the last first, each element once', () => {
    const shelf = new MemoryStorage()
    const kept = new KeptElements(() => shelf)
    for (const [name, x] of [
      ['a', 0.1],
      ['b', 1 / 3],
      ['c', 0.1],
    ] as const)
      kept.add(element(name, x))
    const next = new KeptElements(() => shelf)
    expect(next.elements).toEqual([element('c', 0.1), element('b', 1 / 3)])
    expect(next.persistence).toBe('stored')
    next.remove(element('?', 0.1))
    kept.read()
    expect(names(kept)).toEqual(['b'])
  })

  it('does not lose what another page keeps at the same time', () => {
    const shelf = new MemoryStorage()
    const [one, other] = [new KeptElements(() => shelf), new KeptElements(() => shelf)]
    one.add(element('one', 1.5))
    other.add(element('other', 2.5))
    one.read()
    expect(names(one)).toEqual(['other', 'one'])
  })

  it('lasts as long as the page where storage is refused, or full', () => {
    const refused = new KeptElements(() => {
      throw new DOMException('no', 'SecurityError')
    })
    refused.add(element('a', 2))
    expect([names(refused), refused.persistence]).toEqual([['a'], 'unavailable'])
    const shelf = new MemoryStorage()
    const full = new KeptElements(() => shelf)
    full.add(element('a', 2))
    shelf.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError')
    }
    full.add(element('b', 3))
    full.add(element('c', 4))
    expect([names(full), full.persistence]).toEqual([['c', 'b', 'a'], 'unavailable'])
    expect(names(new KeptElements(() => shelf))).toEqual(['a'])
  })

  it('leaves those of a later version alone, and reads around what is none', () => {
    const shelf = new MemoryStorage()
    const later = '{"version":2,"elements":"in another form"}'
    shelf.setItem('hexlens-kept', later)
    const kept = new KeptElements(() => shelf)
    kept.add(element('a', 2))
    expect([names(kept), kept.persistence, shelf.getItem('hexlens-kept')]).toEqual([['a'], 'newer', later])
    for (const broken of ['', '{', 'null', '[]', '{"version":1,"elements":7}']) {
      shelf.setItem('hexlens-kept', broken)
      expect(new KeptElements(() => shelf)).toMatchObject({ elements: [], persistence: 'stored' })
    }
    const cells = [null, 3, { vertices: [1, 2] }, { name: 'good', vertices: unitCube, property: 'valid' }]
    shelf.setItem('hexlens-kept', JSON.stringify({ version: 1, elements: cells }))
    expect(names(new KeptElements(() => shelf))).toEqual(['good'])
  })

  it('is exported as the command line and Paste read it', () => {
    const list = [element('a', 1 / 3), element('b "quoted"', 1e-300)]
    const readBack = (text: string) => JSON.parse(text).map(readHexahedron)
    expect(readBack(exported(list))).toEqual(list.map(({ name, vertices }) => ({ name, vertices })))
    expect(readBack(exported([]))).toEqual([])
    const pasted = readText('found.json', exported(list))
    expect(list.map((_, cell) => verticesOf(pasted, cell))).toEqual(list.map(({ vertices }) => vertices))
    expect(pasted.ids).toEqual(['a', 'b "quoted"'])
  })
})

describe('searches', () => {
  const shelves = () => {
    const [tab, latest] = [new MemoryStorage(), new MemoryStorage()]
    return { tab: () => tab, latest: () => latest }
  }
  const find = (index: number) => ({
    index,
    vertices: unitCube.with(0, -0).with(1, index / 7),
    complexity: index,
    extremeness: index === 3 ? -Infinity : 1 / index,
  })
  const recordOf = (seed: number, blocks = 10): SearchRecord => {
    const query = queryOf(formOf(entry(kinds, 0), String(seed)))
    const finds = [1, 2, 3].map(find)
    return { find: 'corners', ran: 12.5, tally: Tally.from({ query, blocks, found: 19_506, finds }) }
  }
  const workOf = (...searches: SearchRecord[]): SearchWork => ({
    form: 'find=corners&seed=7',
    vertices: unitCube.with(2, 1 / 3),
    order: 'extremeness',
    searches,
  })

  it('are there for the next page with their finds, bit for bit', () => {
    const stored = shelves()
    const keeper = new SearchKeeper(stored)
    expect(keeper.found()).toBeNull()
    keeper.keep(workOf(recordOf(1), recordOf(2)))
    const work = new SearchKeeper(stored).found()
    expect({ ...work, searches: [] }).toEqual(workOf())
    expect(work?.searches.map(({ tally }) => tally.document)).toEqual([1, 2].map(seed => recordOf(seed).tally.document))
    expect(work?.searches[0]).toMatchObject({ find: 'corners', ran: 12.5 })
    const tally = work?.searches[0]?.tally
    expect([tally?.found, tally?.elements, tally?.finds('simplicity').length]).toEqual([19_506, 10_240, 3])
    expect(Object.is(tally?.finds('simplicity')[0]?.vertices[0], -0)).toBe(true)
  })

  it('are the latest of each query, as many as there is room for', () => {
    let searches: readonly SearchRecord[] = []
    for (let seed = 0; seed < MOST_SEARCHES + 2; ++seed) searches = withSearch(searches, recordOf(seed))
    searches = withSearch(searches, recordOf(5, 99))
    expect(searches.map(({ tally }) => tally.query.seed)).toEqual([5, 9, 8, 7, 6, 4, 3, 2])
    expect(searchOf(searches, recordOf(5).tally.query)?.tally.blocks).toBe(99)
    expect(searchOf(searches, recordOf(0).tally.query)).toBeUndefined()
  })

  it('that are broken are left out, each alone', () => {
    const stored = shelves()
    const good = recordOf(1)
    const { document } = good.tally
    const broken: unknown[] = [
      null,
      { ...good, tally: { ...document, blocks: -1 } },
      { ...good, tally: { ...document, query: { seed: 1 } } },
      { ...good, tally: { ...document, finds: [{ ...find(1), vertices: [1] }] } },
    ]
    const text = { ...workOf(), searches: [...broken, { ...good, tally: document }] }
    stored.tab().setItem(
      'hexlens-searches-1',
      JSON.stringify(text, (_, x) => (x === -Infinity ? -1e308 : x)),
    )
    expect(new SearchKeeper(stored).found()?.searches.length).toBe(1)
    for (const other of ['7', '{"form":1}', '{"form":"","order":"up","searches":[]}']) {
      stored.tab().setItem('hexlens-searches-1', other)
      expect(new SearchKeeper(stored).found()).toBeNull()
    }
  })
})

describe('the live region', () => {
  afterEach(() => vi.useRealTimers())

  it('says the first find at once, then what is new three times a minute, and the end', () => {
    vi.useFakeTimers({ toFake: ['performance'] })
    const said: string[] = []
    const region = {
      set textContent(text: string) {
        said.push(text)
      },
    }
    const liveRegion = new LiveRegion(region as unknown as HTMLElement)
    liveRegion.begin()
    let found = 0
    for (let second = 0; second <= 60; ++second) {
      if (second >= 5 && second < 45) found += 1
      liveRegion.report({ elements: 1000 * second, found, isRunning: true })
      vi.advanceTimersByTime(1000)
    }
    liveRegion.report({ elements: 61_000, found, isRunning: false })
    expect(said).toEqual([
      'Searching.',
      '1 found among 5,000 elements.',
      '21 found among 25,000 elements.',
      '40 found among 45,000 elements.',
      'Stopped. 40 found among 61,000 elements.',
    ])
  })
})
