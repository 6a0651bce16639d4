/** What the page Mesh says about files, folders, refusals and what to do next. */
import { expect, test } from 'vitest'
import { WaitingFiles } from '../../web/input/waiting-files'
import {
  acceptedSentence,
  cancelledWords,
  namesakeSentence,
  nextSentence,
  refusalWords,
} from '../../web/pages/mesh/page-words'
import type { Overview, Row } from '../../web/survey/survey-jobs'

const file = (name: string) => ({ name }) as File

test('a refusal names what was given, once, and what is still there', () => {
  expect(refusalWords('a.vtu', 'a.vtu, byte 3: no.', 'b.vtu')).toBe('a.vtu, byte 3: no. What is below is still b.vtu.')
  expect(refusalWords('a.vtu', 'Read as VTU: no hexahedra.', null)).toBe('a.vtu: read as VTU: no hexahedra.')
  expect(refusalWords('the text', 'No mesh.', null)).toBe('No mesh.')
  expect(cancelledWords(null)).toBe('Cancelled.')
  expect(cancelledWords('the example')).toBe('Cancelled. What is below is still the example.')
})

const overview = (invalid: number, fixes: number, worst: Partial<Row> | null) =>
  ({
    counts: { valid: 5, invalid, unanswered: 0, degenerate: 0 },
    fixes: Array.from({ length: fixes }, () => ({ id: 'mirrored', words: 'Correct' })),
    worst: worst ? [{ id: '7', why: null, relativeMinimum: 0.25, ...worst }] : [],
  }) as unknown as Overview

test('invalid cells lead to the files, corrections are their own way, and valid meshes have a least minimum', () => {
  expect(nextSentence(overview(2, 0, {}))).toMatch(/^Their ids, .*Take away/)
  expect(nextSentence(overview(1, 0, {}))).toMatch(/^Its id, /)
  expect(nextSentence(overview(2, 1, {}))).toBe('')
  expect(nextSentence(overview(0, 0, {}))).toMatch(/^The least relative minimum is 0\.25, of cell 7:/)
  expect(nextSentence(overview(0, 0, { why: 'not finite' }))).toBe('')
  expect(nextSentence(overview(0, 0, null))).toBe('')
})

test('who accepts an invalid cell is said of it, and of no other', () => {
  const acceptedBy = ['corners', 'gauss-2'] as const
  expect(acceptedSentence({ standing: 'invalid', acceptedBy })).toBe('Accepted by eight corners, 2×2×2 Gauss points.')
  expect(acceptedSentence({ standing: 'invalid', acceptedBy: [] })).toBe('')
  expect(acceptedSentence({ standing: 'valid', acceptedBy })).toBe('')
})

test('equal names in several folders are told, others are not', () => {
  expect(namesakeSentence(undefined)).toBe('')
  expect(namesakeSentence(['run/a.vtu', 'run/b.vtu'])).toBe('')
  expect(namesakeSentence(['r1/a.vtu', 'r1/b.vtu', 'r2/A.vtu'])).toContain('r1/a.vtu and r2/A.vtu among them')
})

test('files wait for those that they name, with their paths', () => {
  const waiting = new WaitingFiles()
  const first = { files: [file('a.pvtu'), file('a_0.vtu')], paths: ['t/a.pvtu', 't/a_0.vtu'] }
  waiting.refused(first, ['a_1.vtu'])
  const other = { files: [file('b.vtu')] }
  expect(waiting.completed(other)).toBe(other)
  expect(waiting.completed({ files: [file('a_1.vtu')] })).toMatchObject({
    paths: ['t/a.pvtu', 't/a_0.vtu', 'a_1.vtu'],
  })
  waiting.refused(null, [])
  const late = { files: [file('a_1.vtu')] }
  expect(waiting.completed(late)).toBe(late)
})
