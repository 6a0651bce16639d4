/** What is left out of a library in the package's files, and what never is. */
import { expect, it } from 'vitest'
import { withoutUnread } from '../../tools/unread-members.mjs'

const library = `
  export class Box {
    isBox = true
    set width(value) { this.seen = value }
    size() { return this.area() }
    area() { if (this.isSphere) return 'round'; return 'flat' }
    perimeter() { return this.circumference() }
    circumference() { return 'long' }
    byName() { return 'named' }
    toString() { return 'box' }
  }
  export function options() { const unused = () => 1; return { passive: false, unused } }`

it('leaves out what nobody reads, and what only that reads; keeps setters, options and names in texts', async () => {
  const rest = [`import { Box } from 'library'; const box = new Box(); box.width = 2; box.size(); box['byName']()`]
  const lean = await withoutUnread(library, rest, new Set(['isBox', 'isSphere']))
  for (const gone of ['isBox', 'isSphere', 'round', 'perimeter', 'circumference']) expect(lean).not.toContain(gone)
  for (const kept of ['set width', 'size()', 'area()', 'byName', 'toString', 'passive']) expect(lean).toContain(kept)
  const set = await withoutUnread(library, [...rest, 'box.isSphere = true'], new Set(['isSphere']))
  expect(set).toContain('round')
})
