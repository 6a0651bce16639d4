/** The manifest, which docs/element.md is written from too, against the element itself. */
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { attributeNames } from '../../web/element/attributes'
import { HexLens } from '../../web/element/hex-lens'
import { panels } from '../../web/panels/list'
import { nearest } from '../../web/panels/nearest'

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')
const [element] = JSON.parse(read('custom-elements.json')).modules[0].declarations
const names = (key: string) => (element[key] as { name: string }[]).map(({ name }) => name)
const members = (kind: string) => element.members.filter((member: { kind: string }) => member.kind === kind)

/** The descriptor in the class or in those that it extends. */
function descriptorOf(name: string): PropertyDescriptor | undefined {
  const chain = [HexLens.prototype, Object.getPrototypeOf(HexLens.prototype)]
  return chain.map(each => Object.getOwnPropertyDescriptor(each, name)).find(found => found !== undefined)
}

describe('the manifest', () => {
  it('has the attributes that are observed', () => {
    expect(names('attributes').sort()).toEqual([...attributeNames].sort())
  })

  it('has properties and methods that are there, and no more writable than it says', () => {
    for (const { name, readonly = false } of members('field')) {
      const { get, set } = descriptorOf(name) ?? {}
      expect([name, typeof get, set === undefined]).toEqual([name, 'function', readonly])
    }
    for (const { name } of members('method'))
      expect([name, typeof descriptorOf(name)?.value]).toEqual([name, 'function'])
  })

  it('has the events that are told', () => {
    const source = ['hex-lens', 'changes', 'looking'].map(name => read(`web/element/${name}.ts`)).join('')
    const told = [...source.matchAll(/\btell\('(hex-[\w-]+)'/g)].map(match => match[1])
    expect([...new Set(told)].sort()).toEqual(names('events').sort())
  })

  it('has the states that are set', () => {
    const set = [...read('web/element/readiness.ts').matchAll(/#set\('(\w+)'/g)].map(match => match[1])
    expect(element.cssStates.map(({ name }: { name: string }) => name).sort()).toEqual([...new Set(set)].sort())
  })

  it('has a CSS part of every view, and says each that can be chosen', () => {
    const all = [...panels, nearest]
    const views = all.map(({ name }) => name)
    expect(names('cssParts')).toEqual(expect.arrayContaining(views))
    const { description } = element.attributes.find(({ name }: { name: string }) => name === 'views')
    for (const { name, always, with: other } of all) if (!always && !other) expect(description).toContain(`\`${name}\``)
    const own = [...read('web/element/view-host.ts').matchAll(/ part="(\w+)"/g)].map(match => match[1])
    expect(names('cssParts')).toEqual(expect.arrayContaining(own))
  })

  it('has the slots and the custom properties of the style sheet', () => {
    const styles = read('web/element/hex-lens.css')
    const used = new Set([...styles.matchAll(/--hl-[\w-]+/g)].map(([name]) => name))
    expect(names('cssProperties').sort()).toEqual([...used].sort())
    expect(names('slots')).toEqual(['', 'hint', 'list', 'caption'])
    expect(read('web/panels/reading/reading.ts')).toContain('slot name="list"')
    expect(read('web/element/view-host.ts')).toContain('slot name="caption"')
    expect(read('web/scene/input/controls.ts')).toContain(".name = 'hint'")
  })
})
