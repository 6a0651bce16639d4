/** Series of challenges and what is handed in of them, there and back; what is refused; QR codes read by another program. */
import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import fc from 'fast-check'
import jsQR from 'jsqr'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { written } from '../../web/model/document-readers'
import { type ChallengeDocument, LIMITS } from '../../web/pages/challenges/challenge'
import { challengeFragment, lengthWarning, readChallengeAddress } from '../../web/pages/challenges/challenge-link'
import {
  documentOf,
  newDraft,
  newWriting,
  readWriting,
  titleOf,
  withDraft,
  withMember,
  withMoved,
  withoutMember,
} from '../../web/pages/challenges/drafts'
import { shortFraction } from '../../web/pages/challenges/exact-words'
import { differencesInWords, handedInView, judgedAnew } from '../../web/pages/challenges/handed-in'
import { MadeInSeries } from '../../web/pages/challenges/made'
import { MOST_BYTES, qrCode } from '../../web/pages/challenges/qr-code'
import { MOST_CHALLENGES, readSeries, type SeriesDocument } from '../../web/pages/challenges/series'
import { decodeSeries, encodeSeries, MOST_JSON } from '../../web/pages/challenges/series-code'
import { core, unitCube } from './core-fixtures'

const schema = JSON.parse(readFileSync(new URL('../../docs/series.schema.json', import.meta.url), 'utf8'))
const fits = new Ajv2020({ strict: true }).compile(schema)

const challenge: ChallengeDocument = {
  version: 1,
  title: 'A wedge',
  text: 'Collapse an edge.',
  start: unitCube,
  goal: ['boundary_min = 0', 'moved <= 1'],
}

const element = fc.array(fc.oneof(fc.double({ noNaN: true, noDefaultInfinity: true }), fc.constant(-0)), {
  minLength: 24,
  maxLength: 24,
})
const plain = (maxLength: number) =>
  fc.string({ unit: 'grapheme', minLength: 1, maxLength: maxLength / 8 }).filter(text => !/[<&]|^\s*$/.test(text))
const challengeDocument: fc.Arbitrary<ChallengeDocument> = fc.record({
  version: fc.constant(1 as const),
  title: plain(LIMITS.title),
  text: plain(LIMITS.text),
  start: element.map(written),
  goal: fc.constantFrom(['valid'], ['not valid', 'corner_min > 1/8']),
})

describe('a series', () => {
  it('comes back from its link bit for bit, with what is handed in', async () => {
    const series = fc
      .array(fc.oneof(fc.constantFrom('one-vertex', 'most-twisted'), challengeDocument), { minLength: 1, maxLength: 5 })
      .chain(challenges =>
        fc.record({
          version: fc.constant(1 as const),
          challenges: fc.constant(challenges),
          handedIn: fc.option(
            fc.record({
              name: fc.option(plain(LIMITS.title)),
              elements: fc.tuple(...challenges.map(() => fc.option(element.map(written)))),
            }),
          ),
        }),
      )
    await fc.assert(
      fc.asyncProperty(series, async document => {
        expect([fits(document), fits.errors]).toEqual([true, null])
        const fragment = challengeFragment({
          kind: 'series',
          code: await encodeSeries(document),
          at: 0,
          vertices: null,
        })
        expect(fragment).toMatch(/^series=[\w-]+$/)
        const address = readChallengeAddress(`#${fragment}`)
        if (!address.ok || address.value.kind !== 'series') throw new Error('It is no series.')
        const result = await decodeSeries(address.value.code)
        if (!result.ok) throw new Error(result.error)
        const { members, handedIn } = result.value
        const again: SeriesDocument = {
          version: 1,
          challenges: members.map(({ document }) => document),
          handedIn: handedIn && {
            name: handedIn.name,
            elements: handedIn.elements.map(vertices => vertices && written(vertices)),
          },
        }
        expect(again).toEqual(document)
        for (const [i, { challenge }] of members.entries()) {
          const given = document.challenges[i]
          if (typeof given === 'object') expect(written(challenge.start)).toEqual(given.start)
        }
      }),
      { numRuns: 50 },
    )
  })

  it('of many long texts is warned of, and comes back', async () => {
    const random = fc.sample(fc.string({ minLength: LIMITS.text, maxLength: LIMITS.text }), {
      numRuns: MOST_CHALLENGES,
      seed: 1,
    })
    const challenges = random.map(text => ({ ...challenge, text: text.replaceAll(/[<&]/g, '+') }))
    const code = await encodeSeries({ version: 1, challenges })
    expect(await decodeSeries(code)).toMatchObject({ ok: true, value: { members: { length: MOST_CHALLENGES } } })
    expect(lengthWarning(`https://x/#series=${code}`)).toMatch(/^The link has \d+ characters\. Some mail/)
    expect(lengthWarning('x'.repeat(8000))).toBe('')
    expect(await qrCode(code)).toBeNull()
  })

  it.each<[unknown, RegExp]>([
    [[], /^series has to be an object\.$/],
    [{ version: 2, challenges: [] }, /^The series is of version 2, which is not known here\.$/],
    [{ version: 1, challenges: [] }, /^series\.challenges is empty\.$/],
    [{ version: 1, challenges: ['none'] }, /^There is no challenge “none”\.$/],
    [
      { version: 1, challenges: Array(13).fill('one-vertex') },
      /^series\.challenges has 13 challenges; 12 are the most\.$/,
    ],
    [
      { version: 1, challenges: [challenge, { ...challenge, title: '' }] },
      /^series\.challenges\[1\]\.title is empty\.$/,
    ],
    [{ version: 1, challenges: [{ ...challenge, version: 3 }] }, /of version 3/],
    [{ version: 1, challenges: ['one-vertex'], handedIn: { elements: [] } }, /^series\.handedIn\.elements is empty\.$/],
    [
      { version: 1, challenges: ['one-vertex'], handedIn: { elements: [null, null] } },
      /needs an element or null for each/,
    ],
    [{ version: 1, challenges: ['one-vertex'], handedIn: { name: '<b>x', elements: [null] } }, /looks like HTML/],
  ])('%# is refused in a sentence', (given, sentence) => {
    const result = readSeries(given)
    expect(result.ok ? '' : result.error).toMatch(sentence)
  })

  it('that is cut off, changed, or endless is refused in a sentence', async () => {
    const code = await encodeSeries({ version: 1, challenges: [challenge, 'one-vertex'] })
    for (let length = 1; length < code.length; length += 7)
      expect(await decodeSeries(code.slice(0, length))).toMatchObject({
        ok: false,
        error: expect.stringMatching(/^The link is broken: /),
      })
    expect(await decodeSeries('%%')).toMatchObject({ ok: false })
    const endless = await encodeSeries({ version: 1, challenges: ['x'.repeat(50 * MOST_JSON)] })
    expect(endless.length).toBeLessThan(20_000)
    expect(await decodeSeries(endless)).toEqual({
      ok: false,
      error: `The link is broken: it holds more than ${MOST_JSON} characters.`,
    })
  })

  it('has a place in the address, which no other has', () => {
    const vertices = unitCube.with(0, -0)
    for (const address of [
      { kind: 'series', code: 'a-_9', at: 0, vertices: null },
      { kind: 'series', code: 'a-_9', at: 3, vertices },
    ] as const)
      expect(readChallengeAddress(`#${challengeFragment(address)}`)).toEqual({ ok: true, value: address })
    expect(readChallengeAddress('#challenge=one-vertex&at=2')).toEqual({
      ok: false,
      error: 'The link is broken: only a series has at=.',
    })
  })
})

describe('what is handed in', () => {
  it('is judged by its elements alone', async () => {
    const read = readSeries({
      version: 1,
      challenges: ['one-vertex', challenge, challenge],
      handedIn: {
        name: 'Ada',
        isSolved: true,
        elements: [unitCube, unitCube.with(18, 0.5).with(19, 0.5).with(20, 0), null],
      },
    })
    if (!read.ok || !read.value.handedIn) throw new Error('It is not read.')
    const view = await judgedAnew(handedInView(read.value.members, read.value.handedIn), async vertices => {
      const result = core.analyze(vertices)
      if (!result.ok) throw new Error(result.error.message)
      return result.value
    })
    expect(view.name).toBe('Ada')
    expect(view.members.map(({ answer }) => answer?.judgement.isSolved ?? null)).toEqual([false, false, null])
    expect(view.members[1]?.answer?.judgement.truths).toEqual([false, true])
  })

  it('says how it differs from the start and from the solution', () => {
    const moved = unitCube.with(0, 0.25).with(5, 7)
    expect(differencesInWords(moved, unitCube, null)).toBe(
      '2 vertices are moved from the start. No solution is stored.',
    )
    expect(differencesInWords(moved, unitCube, moved)).toMatch(/It is the stored solution\.$/)
    expect(differencesInWords(unitCube.with(0, -0), unitCube, moved)).toBe(
      '0 vertices are moved from the start. It is not the stored solution: 2 vertices differ.',
    )
  })

  it('has short fractions where they are exact', () => {
    expect(shortFraction({ numerator: -6n, denominator: 24n })).toBe('−1/4')
    expect(shortFraction({ numerator: 8n, denominator: 4n })).toBe('2')
    expect(shortFraction({ numerator: 0n, denominator: 5n })).toBe('0')
    expect(shortFraction({ numerator: 1n, denominator: 10n ** 30n })).toBeNull()
  })
})

describe('what a reader has made in a series', () => {
  afterEach(() => vi.unstubAllGlobals())

  it('is kept: what solves a challenge is only replaced by what solves it', () => {
    const kept = new Map<string, string>()
    vi.stubGlobal('localStorage', {
      getItem: (key: string) => kept.get(key) ?? null,
      setItem: (key: string, value: string) => kept.set(key, value),
      removeItem: (key: string) => kept.delete(key),
    })
    const [one, other] = [new MadeInSeries(), new MadeInSeries()]
    const solved = { vertices: unitCube.with(0, -0), isSolved: true }
    one.add('code', 1, solved)
    other.add('code', 0, { vertices: unitCube, isSolved: false })
    other.add('code', 1, { vertices: unitCube, isSolved: false })
    other.add('another', 0, solved)
    const all = new MadeInSeries().of('code')
    expect(all).toEqual([{ vertices: unitCube, isSolved: false }, solved])
    expect(Object.is(all[1]?.vertices[0], -0)).toBe(true)
    other.forget()
    expect([kept.size, other.isEmpty]).toEqual([0, true])
    for (const text of ['{', '{"version":1,"series":[["a",[{"vertices":[1]}]]]}', '{"version":9,"series":3}', 'null']) {
      kept.set('hexlens-series', text)
      expect(new MadeInSeries().of('a')).toEqual([])
    }
  })

  it('is known without a storage, too', () => {
    vi.stubGlobal('localStorage', undefined)
    const made = new MadeInSeries()
    made.add('code', 0, { vertices: unitCube, isSolved: true })
    expect(made.of('code')).toHaveLength(1)
  })
})

describe('what a teacher is writing', () => {
  it('is a list that is never empty, and the form stays with its challenge', () => {
    let writing = withDraft(newWriting(), { title: 'a' })
    writing = withMember(writing, { kind: 'of this page', id: 'one-vertex' })
    writing = withDraft(withMember(writing, newDraft()), { title: 'c' })
    const titles = () => writing.members.map(titleOf)
    expect([titles(), writing.at]).toEqual([['a', 'Break it with one vertex', 'c'], 2])
    writing = withMoved(writing, 2, -1)
    expect([titles(), writing.at]).toEqual([['a', 'c', 'Break it with one vertex'], 1])
    writing = withMoved(writing, 0, -1)
    writing = withoutMember(writing, 0)
    expect([titles(), writing.at]).toEqual([['c', 'Break it with one vertex'], 0])
    writing = withoutMember(withoutMember(writing, 1), 0)
    expect(writing).toEqual(newWriting())
  })

  it('is read again as it was kept; anything else is nothing', () => {
    const writing = withMember(withDraft(newWriting(), { solution: unitCube }), {
      kind: 'of this page',
      id: 'one-vertex',
    })
    expect(readWriting(JSON.parse(JSON.stringify(writing)))).toEqual(writing)
    const draft = newDraft()
    for (const members of [
      [],
      [{ ...draft, title: 1 }],
      [{ ...draft, start: [1] }],
      [{ ...draft, goal: [{ kind: 'claim' }] }],
    ])
      expect(readWriting({ members, at: 0 })).toBeNull()
    for (const value of [null, 3, { members: [draft], at: 1 }, { members: [{ kind: 'of this page', id: 'x' }], at: 0 }])
      expect(readWriting(value)).toBeNull()
  })

  it('is a document that the reader takes', () => {
    const { members } = withDraft(newWriting(), { title: 'T', text: 'x' })
    const documents = [...members, { kind: 'of this page', id: 'one-vertex' } as const].map(e =>
      documentOf(e, unitCube),
    )
    expect(readSeries({ version: 1, challenges: documents }).ok).toBe(true)
  })
})

describe('a QR code', () => {
  /** The text that a reader finds in the picture of four pixels a module. */
  function scanned({ side, path }: { side: number; path: string }): string | undefined {
    const scale = 4
    const width = scale * side
    const pixels = new Uint8ClampedArray(4 * width * width).fill(255)
    for (const [, x, y, length] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\d+z/g))
      for (let row = scale * Number(y); row < scale * (Number(y) + 1); row++)
        for (let column = scale * Number(x); column < scale * (Number(x) + Number(length)); column++)
          pixels.fill(0, 4 * (row * width + column), 4 * (row * width + column) + 3)
    return jsQR(pixels, width, width)?.data
  }

  it.each([40, 300, 1000, 2331, 2332, MOST_BYTES])('of %d bytes is read again', async length => {
    const text = 'https://example.org/challenges.html#series='.padEnd(length, 'aZ09-_').slice(0, length)
    const code = await qrCode(text)
    if (code === null) throw new Error('There is none.')
    expect(scanned(code)).toBe(text)
    // Four modules of quiet zone on each side.
    expect(code.path.startsWith('M4 4h7')).toBe(true)
    expect((code.side - 8 - 17) % 4).toBe(0)
  })

  it('is not made of more than it holds', async () => {
    expect(await qrCode('x'.repeat(MOST_BYTES + 1))).toBeNull()
  })
})
