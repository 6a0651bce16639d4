/** The list of words: complete in every language, with the same holes, and nothing in it that is not said. */
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { afterEach, describe, expect, it } from 'vitest'
import { whySentence } from '../../web/panels/verdict/why'
import { german } from '../../web/words/de'
import { english, type Word } from '../../web/words/english'
import { addLanguage, listed, say, sayParts, speak } from '../../web/words/say'
import { chinese } from '../../web/words/zh'

const holes = (sentence: string) => [...new Set(sentence.match(/\{\w+\}/g) ?? [])].sort()

describe('the list of words', () => {
  it('has each once, in the order of the alphabet', () => {
    const small = english.map(word => word.toLowerCase())
    expect(small).toEqual(small.toSorted())
    expect(new Set(english).size).toBe(english.length)
  })

  it('has nothing that the sources do not say', () => {
    const files = readdirSync('web', { recursive: true, encoding: 'utf8' }).filter(
      name => name.endsWith('.ts') && !/^(words\/(de|zh|english)\.ts|pages\/)/.test(name.replaceAll('\\', '/')),
    )
    const sources = files
      .map(name => readFileSync(join('web', name), 'utf8').replaceAll('\\u00a0', '\u00a0'))
      .join('\n')
    expect(english.filter(word => !sources.includes(`'${word}'`) && !sources.includes(`${word}: `))).toEqual([])
  })

  for (const [name, dictionary] of Object.entries({ german, chinese })) {
    it(`is complete in ${name}, with the same holes`, () => {
      expect(Object.keys(dictionary).sort()).toEqual([...english].sort())
      for (const word of english) expect([word, holes(dictionary[word])]).toEqual([word, holes(word)])
      expect(english.filter(word => /[{}]/.test(dictionary[word].replace(/\{\w+\}/g, '')))).toEqual([])
    })
  }

  it('is in other words throughout: what is the same is a name', () => {
    const same = english.filter(word => german[word] === word && /[a-z]{3}/.test(word.replace(/\{\w+\}/g, '')))
    expect(same).toMatchInlineSnapshot(`
      [
        "Block",
        "conf.py",
        "deal.II",
        "deal.II, DOLFINx, VTK_VOXEL",
        "Escape",
        "Index",
        "Knabner, Korotov, Summ",
        "Link",
        "Maximum",
        "Minimum",
        "Minimum, {part}: jacdet {jacdet}. {point}. {position}.",
        "mkdocs.yml",
        "OpenVolumeMesh",
        "Verdict in VTK, PyVista, ParaView",
      ]
    `)
    for (const word of english)
      if (chinese[word] === word) expect(same.concat('P', 'M', 'HXT', 'AVS UCD')).toContain(word)
  })
})

describe('what is said', () => {
  afterEach(() => speak('en'))

  it('is English without a language, and in a language that has not arrived', () => {
    expect(say('Undo')).toBe('Undo')
    speak('fr')
    expect(say('{number} of {count}', { number: 3, count: 26 })).toBe('3 of 26')
  })

  it('fills holes in the order of the language', () => {
    addLanguage('x', {
      ...german,
      '{number} of {count}': 'von {count} die {number}',
      '{names} and {last}': '{last} & {names}',
    })
    speak('x')
    expect(say('{number} of {count}', { number: 3, count: 26 })).toBe('von 26 die 3')
    expect(sayParts('at {point}', { point: 7 })).toEqual(['bei ', 7, ''])
    expect(listed(['1', '2', '3'])).toBe('3 & 1, 2')
    expect(say('Undo')).toBe('Rückgängig')
  })

  it('is English where a language lacks a sentence', () => {
    addLanguage('y', {} as Record<Word, string>)
    speak('y')
    expect(say('Undo')).toBe('Undo')
  })

  it('has whole sentences about an element', () => {
    addLanguage('de', german)
    speak('de')
    const report = { valid: true, class: 'valid', coincident: [] } as unknown as Parameters<typeof whySentence>[0]
    expect(whySentence(report)).toBe(
      german['J > 0 on all six faces, so J > 0 everywhere (Knupp’s conjecture, now a theorem).'],
    )
  })
})
