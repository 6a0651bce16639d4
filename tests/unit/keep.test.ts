/** The reader's work in storages that keep, refuse, are full, or hold something else. */
import { describe, expect, it } from 'vitest'
import { KEEPING_NOTES, Keeper, type Shelves } from '../../web/pages/keep'

class Shelf {
  readonly items = new Map<string, string>()
  room = Infinity
  getItem(key: string): string | null {
    return this.items.get(key) ?? null
  }
  setItem(key: string, value: string): void {
    if (value.length > this.room) throw new DOMException('full', 'QuotaExceededError')
    this.items.set(key, value)
  }
  removeItem(key: string): void {
    this.items.delete(key)
  }
}

type Numbers = readonly number[]

function readNumbers(value: unknown): Numbers | null {
  return Array.isArray(value) && value.every(x => typeof x === 'number') ? value : null
}

function keeperIn(shelves: Shelves, version = 1): Keeper<Numbers> {
  return new Keeper('test', version, readNumbers, shelves)
}

/** Two tabs of one browser; a copy of a tab has a copy of its storage. */
function browser() {
  const latest = new Shelf()
  const tab = (shelf = new Shelf()) => ({ shelf, shelves: { tab: () => shelf, latest: () => latest } })
  return { latest, tab }
}

describe('the reader’s work', () => {
  it('is there for the tab’s next page, bit for bit', () => {
    const { shelves } = browser().tab()
    const numbers = [-0, 0, 1 / 3, 5e-324, -1.7976931348623157e308, Number.NaN, Infinity, -Infinity]
    expect(keeperIn(shelves).found()).toBeNull()
    expect(keeperIn(shelves).keep(numbers)).toBe('kept')
    const found = keeperIn(shelves).found() ?? []
    expect(found.length).toBe(numbers.length)
    found.forEach((x, i) => {
      expect(x).toBe(numbers[i])
    })
  })

  it('is a new tab’s first, and what that tab does is not this one’s', () => {
    const { tab } = browser()
    const [first, second] = [tab(), tab()]
    keeperIn(first.shelves).keep([1])
    const other = keeperIn(second.shelves)
    expect([other.own(), other.found()]).toEqual([null, [1]])
    other.keep([2])
    expect(keeperIn(first.shelves).found()).toEqual([1])
    expect(keeperIn(second.shelves).found()).toEqual([2])
    expect(keeperIn(tab().shelves).found()).toEqual([2])
  })

  it('is forgotten in its tab, and in new ones if it was the latest', () => {
    const { tab } = browser()
    const [first, second] = [tab(), tab()]
    keeperIn(first.shelves).keep([1])
    keeperIn(second.shelves).keep([2])
    keeperIn(first.shelves).forget()
    expect(keeperIn(first.shelves).own()).toBeNull()
    expect(keeperIn(tab().shelves).found()).toEqual([2])
    keeperIn(second.shelves).forget()
    expect(keeperIn(tab().shelves).found()).toBeNull()
  })

  it('is said to last as long as the page where there is no room or no storage, and never turns old', () => {
    const { tab, latest } = browser()
    const { shelf, shelves } = tab()
    const keeper = keeperIn(shelves)
    keeper.keep([1])
    shelf.room = latest.room = 8
    expect(keeper.keep([1, 2, 3, 4, 5])).toBe('full')
    expect([keeper.keeping, keeper.own()]).toEqual(['full', null])
    expect(keeper.keep([6])).toBe('kept')

    const refuse = () => {
      throw new DOMException('no', 'SecurityError')
    }
    const refused = keeperIn({ tab: refuse, latest: refuse })
    expect([refused.keep([1]), refused.found()]).toEqual(['refused', null])
    refused.forget()
    expect(KEEPING_NOTES.full).not.toBe(KEEPING_NOTES.refused)
    expect(KEEPING_NOTES.kept).toBe('')
  })

  it('of another version, or what is no such work, is left alone', () => {
    const { shelf, shelves } = browser().tab()
    keeperIn(shelves, 2).keep([2])
    expect(keeperIn(shelves, 1).found()).toBeNull()
    keeperIn(shelves, 1).keep([1])
    expect(keeperIn(shelves, 2).found()).toEqual([2])
    for (const broken of ['', '{', 'null', '[null]', '{"#number":"-0"}']) {
      shelf.setItem('hexlens-test-1', broken)
      expect(keeperIn(shelves).own(), broken).toBeNull()
    }
  })
})
