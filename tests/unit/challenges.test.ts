/** Every challenge on the real core, and what is read of a teacher's, against the schema. */
import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import { describe, expect, it } from 'vitest'
import { quantitiesOf } from '../../web/core/quantities'
import { NUMBERS } from '../../web/model/condition/names'
import type { Vertices } from '../../web/model/hexahedron'
import { twistOf } from '../../web/model/twist'
import { elementAt } from '../../web/model/way'
import {
  type Challenge,
  type ChallengeDocument,
  judged,
  LIMITS,
  MOST_CHARACTERS,
  readChallenge,
  readChallengeText,
} from '../../web/pages/challenges/challenge'
import { challengeFragment, readChallengeAddress } from '../../web/pages/challenges/challenge-link'
import { challenges, type NamedChallenge } from '../../web/pages/challenges/challenges'
import { numbersInWords } from '../../web/pages/challenges/words'
import { caseVertices, core, unitCube } from './core-fixtures'

const schema = JSON.parse(readFileSync(new URL('../../docs/challenge.schema.json', import.meta.url), 'utf8'))
const fits = new Ajv2020({ strict: true }).compile(schema)

function readOf(document: unknown): Challenge {
  const result = readChallenge(document)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function judgementOf(challenge: Challenge, vertices: Vertices) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return judged(challenge, quantitiesOf(result.value, challenge.start))
}

const document: ChallengeDocument = {
  version: 1,
  title: 'A wedge',
  text: 'Collapse an edge.',
  start: unitCube,
  goal: ['boundary_min = 0', 'moved <= 1'],
}

describe.each(challenges.map(challenge => [challenge.id, challenge] as const))('the challenge %s', (id, given) => {
  const challenge = readOf(given)
  const solution = challenge.solution as Vertices

  it('is what the schema describes, with a solution and a hint', () => {
    expect([fits(given), fits.errors]).toEqual([true, null])
    expect(challenge.hint).not.toBeNull()
    expect(id).toMatch(/^[a-z-]+$/)
    expect(given.record === null || challenge.record?.quantity === given.record.quantity).toBe(true)
  })

  it('is solved by its solution and not at its start', () => {
    expect(judgementOf(challenge, solution)).toEqual({ truths: challenge.goal.map(() => true), isSolved: true })
    expect(judgementOf(challenge, challenge.start).isSolved).toBe(false)
  })

  it('is refused a double before: of two neighbouring ones on the straight way to a solution the first does not do', () => {
    let [low, high] = [0, 1]
    for (let middle = 0.5; middle !== low && middle !== high; middle = (low + high) / 2) {
      if (judgementOf(challenge, elementAt(challenge.start, solution, middle)).isSolved) high = middle
      else low = middle
    }
    const [before, at] = [low, high].map(tau => judgementOf(challenge, elementAt(challenge.start, solution, tau)))
    expect([before?.isSolved, at?.isSolved]).toEqual([false, true])
  })
})

describe('the challenges', () => {
  it('have ids and titles of their own', () => {
    for (const key of ['id', 'title'] as const)
      expect(new Set(challenges.map(each => each[key])).size).toBe(challenges.length)
  })

  it('of edges is also solved by the symmetric element in the unit cube', () => {
    const { id: _, ...edges } = challenges.find(({ id }) => id === 'edges-positive') as NamedChallenge
    expect(judgementOf(readOf(edges), caseVertices('pub/edge_pos/s4_in_cube')).isSolved).toBe(true)
  })
})

describe('a teacher’s challenge', () => {
  it('is read from JSON, as the schema has it, and what is missing is nothing', () => {
    expect(fits(document)).toBe(true)
    const result = readChallengeText(JSON.stringify({ ...document, more: 'of later' }))
    expect(result).toMatchObject({ ok: true, value: { title: 'A wedge', record: null, hint: null, solution: null } })
    const minus = readOf({ ...document, start: ['-0', ...unitCube.slice(1)] })
    expect(Object.is(minus.start[0], -0)).toBe(true)
    expect(schema.properties.record.anyOf[1].properties.quantity.enum).toEqual([...NUMBERS])
    expect(schema.properties.goal.maxItems).toBe(LIMITS.goal)
    for (const key of ['title', 'text'] as const) expect(schema.properties[key].maxLength).toBe(LIMITS[key])
  })

  it.each([
    ['{', 'not-json', /^The challenge is not JSON: .*\.$/],
    ['[]', 'malformed', 'challenge has to be an object.'],
    [
      JSON.stringify({ ...document, version: 2 }),
      'unknown-version',
      'The challenge is of version 2, which is not known here.',
    ],
    [JSON.stringify({ ...document, version: '1' }), 'malformed', 'The challenge’s version has to be 1.'],
    [JSON.stringify({ ...document, title: 7 }), 'malformed', 'challenge.title has to be a text.'],
    [JSON.stringify({ ...document, text: ' ' }), 'malformed', 'challenge.text is empty.'],
    [JSON.stringify({ ...document, start: [1, 2] }), 'malformed', 'challenge.start has to be a list of 24.'],
    [
      JSON.stringify({ ...document, start: unitCube.map(String) }),
      'malformed',
      'challenge.start[0] has to be a finite number, or "-0".',
    ],
    [JSON.stringify({ ...document, goal: [] }), 'malformed', 'challenge.goal needs at least one condition.'],
    [
      JSON.stringify({ ...document, goal: ['valid', 'smoothness > 3'] }),
      'bad-condition',
      /^challenge\.goal\[1\], “smoothness > 3”, is not understood at character 1: .*smoothness/,
    ],
    [JSON.stringify({ ...document, goal: ['valid and'] }), 'bad-condition', /character 10/],
    [JSON.stringify({ ...document, goal: Array(9).fill('valid') }), 'too-large', /9 conditions; 8 are the most/],
    [
      JSON.stringify({ ...document, title: 'A <b>wedge</b>' }),
      'markup',
      'challenge.title is plain text, but it holds “<b”, which looks like HTML.',
    ],
    [JSON.stringify({ ...document, hint: '&lt;script&gt;' }), 'markup', /“&lt;”/],
    [JSON.stringify({ ...document, title: 'x'.repeat(81) }), 'too-large', /81 characters long; 80 are the most/],
    [
      JSON.stringify({ ...document, more: 'x'.repeat(MOST_CHARACTERS) }),
      'too-large',
      /characters long; 8000 are the most/,
    ],
    [
      JSON.stringify({ ...document, record: { quantity: 'beauty', best: 'least' } }),
      'malformed',
      /^challenge\.record\.quantity has to be one of boundary_min/,
    ],
  ])('%# is refused in a sentence', (json, code, message) => {
    const result = readChallengeText(json)
    if (result.ok) throw new Error('It was read.')
    expect(result.error.code).toBe(code)
    expect(result.error.message).toMatch(message)
  })

  it('may say less than and and', () => {
    const { text, goal } = readOf({ ...document, text: 'If a < b & c > d, J < 0.', goal: ['edge_min < 0'] })
    expect([text, goal[0]?.text]).toEqual(['If a < b & c > d, J < 0.', 'edge_min < 0'])
  })
})

describe('the address of a challenge', () => {
  const awkward = unitCube
    .with(0, -0)
    .with(1, 0.1 + 0.2)
    .with(2, 5e-324)
    .with(3, Number.MAX_VALUE)
  const json = JSON.stringify({ ...document, title: 'Är & # % = “x”' })

  it('comes back bit for bit', () => {
    for (const address of [
      { kind: 'list' },
      { kind: 'write' },
      { kind: 'challenge', id: 'one-vertex', vertices: null },
      { kind: 'challenge', id: 'one-vertex', vertices: awkward },
      { kind: 'own', json, vertices: null },
      { kind: 'own', json, vertices: awkward },
    ] as const) {
      const fragment = challengeFragment(address)
      expect(fragment).toMatch(/^[\w\-.!~*'()%=&,]*$/)
      expect(readChallengeAddress(`#${fragment}`)).toEqual({ ok: true, value: address })
    }
  })

  it.each([
    [
      '#other',
      'The link is broken: it should begin with challenge=, own= or series=, and what comes then should not be empty.',
    ],
    [
      '#own=',
      'The link is broken: it should begin with challenge=, own= or series=, and what comes then should not be empty.',
    ],
    ['#own=%7', 'The link is broken: its percent-encoding is cut off or not UTF-8.'],
    ['#challenge=one-vertex&v=1&vertices=1,2', 'The link holds 2 numbers where 24 are needed.'],
    ['#challenge=one-vertex&v=2&vertices=1', 'The link is of version “2”, which is not known here.'],
  ])('%s is refused in a sentence', (fragment, message) => {
    expect(readChallengeAddress(fragment)).toEqual({ ok: false, error: message })
  })
})

describe('the twist', () => {
  const turned = (degrees: number, vertices = unitCube) => {
    const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)]
    return vertices.map((x, i, all) => {
      if (i < 12 || i % 3 === 2) return x
      const [a, b] = [all[i - (i % 3)] as number, all[i - (i % 3) + 1] as number]
      return i % 3 === 0 ? c * a - s * b : s * a + c * b
    })
  }

  it('is the angle by which the top was turned, wherever it lies and however large it is', () => {
    expect(twistOf(unitCube).degrees).toBe(0)
    for (const degrees of [-170, -90, 1, 45, 90, 143.13, 179]) {
      const { degrees: found, error } = twistOf(turned(degrees))
      expect(Math.abs(found - degrees)).toBeLessThanOrEqual(error)
      expect(error).toBeLessThan(1e-9)
      expect(twistOf(turned(degrees).map(x => 2 ** 60 * x)).degrees).toBe(found)
    }
  })

  it('means nothing where the top is a point, and says so', () => {
    expect(twistOf(unitCube.map((x, i) => (i < 12 ? x : 1))).error).toBe(360)
    expect(twistOf(Array(24).fill(0)).error).toBe(360)
  })
})

it('writes one number in one way: the volume minimum is a fraction where the boundary minimum is', () => {
  const challenge = readOf(challenges.find(({ id }) => id === 'lower-inside'))
  const report = core.analyze(challenge.start)
  const [condition] = challenge.goal
  expect(report.ok && condition && numbersInWords(condition, report.value, challenge.start)).toBe('−1/8 and −1/8')
})
