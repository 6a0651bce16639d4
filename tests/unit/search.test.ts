/** Searches with the real workers: what they find, whoever finds it, and what becomes of it when it is polished. */
import { afterAll, expect, it } from 'vitest'
import { quantitiesOf } from '../../web/core/quantities'
import { isCertainlyLess, isMet } from '../../web/model/condition'
import { MOST_TRIED } from '../../web/pages/search/engine/climb'
import { measured } from '../../web/pages/search/engine/measure'
import { parseQuery, type Query } from '../../web/pages/search/engine/query'
import { type Find, Ranking } from '../../web/pages/search/engine/ranking'
import { climbed, polished, Search, type SearchWorkers } from '../../web/pages/search/engine/search'
import { BLOCK } from '../../web/pages/search/engine/search-piece'
import { Tally } from '../../web/pages/search/engine/tally'
import { Improvement, outcomeText } from '../../web/pages/search/improvement'
import { ownSearch, searches } from '../../web/pages/search/searches'
import { certificateOf, checked, type Loose } from './certificate-checker'
import { core, entry, randomSource } from './core-fixtures'
import { edgesArePositive, verticesArePositive } from './exact'
import { batchModules, endThreads, threadsOf } from './node-workers'

const spawn = await threadsOf('web/pages/search/engine/worker.ts')
afterAll(endThreads)

function force(workers: number, module = batchModules.vectors): SearchWorkers {
  return { module, count: workers, spawn }
}

const PIECE = 8 * BLOCK

const kinds = [...searches, ownSearch]

function queryOf(id: string, seed = 1): Query {
  const kind = kinds.find(kind => kind.id === id)
  if (!kind) throw new Error(`There is no search ${id}.`)
  const { property, measure, distribution } = kind
  return { property, measure, distribution, seed }
}

/** Runs until so many elements are looked at. */
async function searched(query: Query, elements: number, workers: SearchWorkers): Promise<Search> {
  const search = await new Promise<Search>((resolve, reject) => {
    const search = new Search(query, workers, () => search.isRunning || resolve(search), reject)
    search.start(elements)
  })
  search.dispose()
  return search
}

function outcome(search: Search) {
  return {
    elements: search.elements,
    found: search.found,
    simplicity: search.finds('simplicity'),
    extremeness: search.finds('extremeness'),
  }
}

function has(query: Query, vertices: readonly number[]): boolean {
  const read = parseQuery(query)
  const report = core.analyze(vertices)
  if (!read.ok || !report.ok) throw new Error('The query or the element was refused.')
  return isMet(read.value.property, quantitiesOf(report.value, read.value.start))
}

/** Certificates of polished elements: another program checks them all. */
const certificates: Loose[] = []
afterAll(() => expect(checked(JSON.stringify(certificates))).toMatchObject({ status: 0, errors: '' }))

/** Elements of the stream of seed 1 among which there is one: 20 seconds on two cores are enough for millions. */
const ENOUGH: Readonly<Record<string, number>> = {
  corners: PIECE,
  edges: 4 * PIECE,
  'depth-guard': 8 * PIECE,
  'nine-points': 2 * PIECE,
  gap: 8 * PIECE,
  own: 2 * PIECE,
}

/** The search of seed 1, once for all tests that need a find of it. */
function searchedEnough(id: string): Promise<Search> {
  const known = searchesDone.get(id) ?? searched(queryOf(id), entry([ENOUGH[id] ?? 0], 0), force(2))
  searchesDone.set(id, known)
  return known
}
const searchesDone = new Map<string, Promise<Search>>()

it.each(kinds.map(({ id }) => id))('finds %s, and what it polishes still has the property, exactly', async id => {
  const query = queryOf(id)
  const search = await searchedEnough(id)
  expect(search.elements).toBe(ENOUGH[id])
  expect(search.found).toBeGreaterThan(0)
  const finds = search.finds('simplicity')
  expect(finds.length).toBeGreaterThan(0)
  for (const { vertices } of finds.slice(0, 5)) expect(has(query, vertices), String(vertices)).toBe(true)

  const steps: number[] = []
  const { vertices, complexity } = await polished(query, entry(finds, 0).vertices, force(1), {
    onStep: step => steps.push(step.complexity),
  })
  expect(has(query, vertices), String(vertices)).toBe(true)
  expect(steps).toEqual(steps.toSorted((a, b) => b - a))
  expect(complexity).toBe(steps.at(-1) ?? entry(finds, 0).complexity)
  expect(complexity).toBeLessThanOrEqual(entry(finds, 0).complexity)
  if (id === 'corners' || id === 'nine-points') expect(verticesArePositive(vertices)).toBe(true)
  if (id === 'edges') expect(edgesArePositive(vertices)).toBe(true)
  const certificate = certificateOf(id, vertices)
  expect(certificate.valid).toBe(id === 'depth-guard')
  expect(checked(JSON.stringify([certificate]))).toMatchObject({ status: 0, errors: '' })
})

it('finds the same with one worker and with three, at once and with stops, with vectors and without', async () => {
  const query = queryOf('corners', 20260803)
  const elements = 6 * PIECE
  const one = outcome(await searched(query, elements, force(1)))
  expect([one.elements, one.simplicity.length, one.extremeness.length]).toEqual([elements, 48, 48])
  expect(outcome(await searched(query, elements, force(3)))).toEqual(one)
  expect(outcome(await searched(query, elements, force(2, batchModules.scalar)))).toEqual(one)

  const stops: number[] = []
  const stopped = await new Promise<Search>((resolve, reject) => {
    const onNews = () => {
      if (search.isRunning) return stops.length === 0 && search.elements > 0 ? search.stop() : undefined
      if (stops.push(search.elements) === 3) return resolve(search)
      search.start(stops.length === 1 ? 5 * PIECE : elements)
      return undefined
    }
    const search = new Search(query, force(2), onNews, reject)
    search.start(4 * PIECE)
  })
  stopped.dispose()
  expect(outcome(stopped)).toEqual(one)
  expect(stops).toEqual([stops[0], 5 * PIECE, elements])
  expect(stops[0]).toBeLessThanOrEqual(4 * PIECE)

  const other = outcome(await searched({ ...query, seed: 20260804 }, PIECE, force(2)))
  expect(other.simplicity.map(({ index }) => index)).not.toEqual(one.simplicity.map(({ index }) => index))
  expect(one.found).toBeGreaterThan(300)
  const complexities = one.simplicity.map(({ complexity }) => complexity)
  expect(complexities).toEqual(complexities.toSorted((a, b) => a - b))
  const extremes = one.extremeness.map(({ extremeness }) => extremeness)
  expect(extremes).toEqual(extremes.toSorted((a, b) => b - a))
})

it('goes on after a stop that waits for nothing, and with new workers after the old ones were ended', async () => {
  const query = queryOf('corners', 5)
  const whole = outcome(await searched(query, 4 * PIECE, force(2)))
  const search = await new Promise<Search>((resolve, reject) => {
    const interruptions = [
      () => search.stop(0),
      () => {
        search.dispose()
        search.start(4 * PIECE)
      },
    ]
    const onNews = () => {
      if (search.elements === 4 * PIECE && !search.isRunning) return resolve(search)
      if (!search.isRunning) return search.start(4 * PIECE)
      return search.elements > 0 ? interruptions.pop()?.() : undefined
    }
    const search = new Search(query, force(2), onNews, reject)
    search.start(4 * PIECE)
  })
  search.dispose()
  expect(outcome(search)).toEqual(whole)
})

it('goes on in another page from what was kept', async () => {
  const query = queryOf('corners', 6)
  const whole = outcome(await searched(query, 4 * PIECE, force(2)))
  const { tally } = await searched(query, PIECE, force(2))
  const kept = Tally.from(JSON.parse(JSON.stringify(tally.document)))
  expect(kept.document).toEqual(tally.document)
  const search = await new Promise<Search>((resolve, reject) => {
    const search = new Search(query, force(2), () => search.isRunning || resolve(search), reject, kept)
    search.start(4 * PIECE)
  })
  search.dispose()
  expect(outcome(search)).toEqual(whole)
})

/** The numbers of an element, and its measure in doubles. */
function judged(query: Query, vertices: readonly number[]) {
  const read = parseQuery(query)
  const report = core.analyze(vertices)
  if (!read.ok || !report.ok) throw new Error('The query or the element was refused.')
  const { measure, start } = read.value
  return {
    measure,
    extremeness: measured(measure, report.value, start),
    quantities: quantitiesOf(report.value, start),
  }
}

it.each(['corners', 'gap', 'nine-points', 'depth-guard'])(
  'climbs from a find of %s, never down, and again the same',
  async id => {
    const query = queryOf(id)
    const find = entry((await searchedEnough(id)).finds('simplicity'), 0)
    const heights: number[] = []
    const best = await climbed(query, find.vertices, force(1), { onStep: step => heights.push(step.extremeness) })
    expect(heights).toEqual(heights.toSorted((a, b) => a - b))
    expect(has(query, best.vertices)).toBe(true)
    const [low, high] = [judged(query, find.vertices), judged(query, best.vertices)]
    expect(high.extremeness).toBe(best.extremeness)
    expect(best.steps > 0).toBe(isCertainlyLess(low.measure, low.quantities, high.quantities))
    if (best.steps === 0) expect(best.vertices).toEqual(find.vertices)
    expect(best.tried).toBeLessThanOrEqual(MOST_TRIED + 64)
    expect(await climbed(query, find.vertices, force(1))).toEqual(best)
  },
)

/** Coordinates that differ, in steps of the grid. */
function movedBy(from: readonly number[], to: readonly number[], step: number): number[] {
  return to.flatMap((x, i) => (x === from[i] ? [] : [(x - (from[i] as number)) / step]))
}

it('climbs only where the distribution goes: its grid, its box, its symmetry, its vertices', async () => {
  const query = queryOf('corners')
  const integers = {
    ...query,
    distribution: { ...query.distribution, law: { kind: 'box', least: -2, greatest: 2 }, grid: 'integers' },
  } as const
  const turned = { ...query, distribution: { ...query.distribution, symmetry: 'third-turn' } } as const
  const two = {
    ...query,
    distribution: { ...query.distribution, law: { kind: 'normal', sigma: 1 }, moved: 2 },
  } as const
  for (const [name, query] of Object.entries({ integers, turned, two })) {
    const find = entry((await searched(query, 64 * BLOCK, force(2))).finds('simplicity'), 0)
    const { vertices, steps } = await climbed(query, find.vertices, force(1))
    expect(steps, name).toBeGreaterThan(0)
    const { law, grid, symmetry } = query.distribution
    expect(movedBy(find.vertices, vertices, grid === 'integers' ? 1 : 0.25).every(Number.isInteger), name).toBe(true)
    if (law.kind === 'box') expect(vertices.every(x => x >= law.least && x <= law.greatest)).toBe(true)
    else expect(vertices.every(x => x >= -6 * law.sigma && x <= 1 + 6 * law.sigma)).toBe(true)
    if (symmetry === 'third-turn') {
      // xi to eta to zeta to xi: vertices 1, 3, 4 and 2, 7, 5.
      const [x, y, z] = vertices.slice(3, 6)
      expect([vertices.slice(9, 12), vertices.slice(12, 15)]).toEqual([
        [z, x, y],
        [y, z, x],
      ])
    }
    if (name === 'two') {
      const start = parseQuery(query)
      const other = start.ok ? start.value.start : []
      const moved = new Set(vertices.flatMap((x, i) => (x === other[i] ? [] : [Math.floor(i / 3)])))
      expect(moved.size).toBeLessThanOrEqual(2)
    }
  }
})

it('a climb that is stopped has come as far as it said', async () => {
  const query = queryOf('depth-guard')
  const find = entry((await searchedEnough('depth-guard')).finds('extremeness'), 0)
  const whole: number[] = []
  await climbed(query, find.vertices, force(1), { onStep: ({ extremeness }) => whole.push(extremeness) })
  const climb = new Improvement({ kind: 'climb', query, vertices: find.vertices, name: 'a' })
  await climb.run(force(1), () => climb.steps >= 5 && climb.stop())
  expect(climb.steps).toBeGreaterThanOrEqual(5)
  expect(climb.steps).toBeLessThan(new Set(whole).size)
  expect(whole).toContain(climb.extremeness)
  expect(judged(query, climb.best).extremeness).toBe(climb.extremeness)
  expect(has(query, climb.best)).toBe(true)
  expect(outcomeText(climb)).toMatch(/^Climbed to 0\.\d+ in \d+ steps, and kept as a-climbed\.$/)

  const nowhere = new Improvement({ kind: 'polish', query, vertices: find.vertices, name: 'a' })
  nowhere.stop()
  await nowhere.run(force(1), () => {})
  expect(nowhere.best).toBe(find.vertices)
  expect(outcomeText(nowhere)).toBe('Nothing simpler was found near this element.')
})

it('says why it does not work', async () => {
  const empty = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0))
  await expect(searched(queryOf('corners'), PIECE, force(2, empty))).rejects.toThrow(/./)
  await expect(searched({ ...queryOf('corners'), property: 'corner_min' }, PIECE, force(1))).rejects.toThrow(
    'This is a number',
  )
  const controller = new AbortController()
  const cancelled = polished(queryOf('edges'), new Array(24).fill(0), force(1), { signal: controller.signal })
  controller.abort(new Error('enough'))
  await expect(cancelled).rejects.toThrow('enough')
})

it('a worker that is ended ends the search, which says so once and goes on with others', async () => {
  const query = queryOf('corners', 5)
  const dying = await threadsOf(
    'web/pages/search/engine/worker.ts',
    `import { parentPort } from 'node:worker_threads'
    let pieces = 0
    parentPort.on('message', ({ kind }) => { if (kind === 'search' && ++pieces === 4) process.exit(7) });`,
  )
  let spawned = 0
  const failures: string[] = []
  const workers = { ...force(2), spawn: () => (spawned++ === 0 ? dying() : spawn()) }
  const search = await new Promise<Search>(resolve => {
    const search = new Search(
      query,
      workers,
      () => search.isRunning || resolve(search),
      ({ message }) => {
        failures.push(message)
        search.start(6 * PIECE)
      },
    )
    search.start(6 * PIECE)
  })
  search.dispose()
  const says = 'a worker of this page ended before it had answered: its thread ended with exit code 7.'
  expect([failures, spawned]).toEqual([[says], 4])
  expect(outcome(search)).toEqual(outcome(await searched(query, 6 * PIECE, force(1))))
})

it('a query that is none is refused field by field', () => {
  const { distribution } = queryOf('corners')
  const law = { kind: 'normal', sigma: -1 } as const
  const result = parseQuery({
    property: 'corner_min >',
    measure: '',
    distribution: { ...distribution, law },
    seed: 1.5,
  })
  expect(result.ok ? [] : result.error.map(({ field, at }) => [field, at])).toEqual([
    ['property', 12],
    ['measure', 0],
    ['distribution', undefined],
    ['seed', undefined],
  ])
})

it('ranks the same whatever the order, each element once', () => {
  const random = randomSource(20260805)
  const finds: Find[] = Array.from({ length: 300 }, (_, index) => {
    const key = Math.floor(60 * random())
    return { index, vertices: new Array(24).fill(key), complexity: key % 7, extremeness: key % 5 }
  })
  for (const order of ['simplicity', 'extremeness'] as const) {
    const rankings = [finds, finds.toReversed(), finds.toSorted((a, b) => (a.index % 17) - (b.index % 17))].map(
      list => {
        const ranking = new Ranking(order, 20)
        for (const find of list) {
          const mayTake = ranking.mayTake(find.complexity, find.extremeness)
          if (ranking.add(find)) expect(mayTake).toBe(true)
        }
        return ranking.finds
      },
    )
    expect(rankings[1]).toEqual(rankings[0])
    expect(rankings[2]).toEqual(rankings[0])
    const kept = entry(rankings, 0)
    expect(new Set(kept.map(({ vertices }) => vertices[0])).size).toBe(20)
    for (const { vertices, index } of kept)
      expect(finds.find(find => find.vertices[0] === vertices[0])?.index).toBe(index)
  }
})
