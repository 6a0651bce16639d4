/** `--junit`: a suite for each file, with a case for the reading, one for validity, one for the bound and one for what is unanswered. */
import { isWhollyAnswered } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import { speakJacdet, speakNumber } from '../model/decimal'
import { markup } from './markup'
import { counted, type FileResult, type Output } from './output'

interface Case {
  readonly name: string
  readonly outcome: 'passed' | 'failure' | 'error' | 'skipped'
  readonly message?: string
  readonly details?: readonly string[]
}

export interface JunitOptions {
  readonly minRelative: number | null
  readonly allowsUnchecked: boolean
}

export function junitOutput(options: JunitOptions): Output {
  let isBegun = false
  return {
    lists: {},
    *file(result) {
      if (!isBegun) yield HEAD
      isBegun = true
      yield suite(result, options)
    },
    *end() {
      yield `${isBegun ? '' : HEAD}</testsuites>\n`
    },
  }
}

const HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="hexlens check">\n'

function suite(result: FileResult, options: JunitOptions): string {
  const cases = 'error' in result ? [unreadable(result.error)] : casesOf(result.check, options)
  const number = (outcome: Case['outcome']) => cases.filter(one => one.outcome === outcome).length
  const counts = `tests="${cases.length}" failures="${number('failure')}" errors="${number('error')}" skipped="${number('skipped')}"`
  const texts = cases.map(one => caseText(result.file, one))
  const notes = 'check' in result ? result.check.notes : []
  const output = notes.length === 0 ? '' : `<system-out>${markup(notes.join('\n'))}</system-out>\n`
  return `<testsuite name="${markup(result.file)}" ${counts}>\n${texts.join('')}${output}</testsuite>\n`
}

function unreadable(error: string): Case {
  return { name: 'the file is read', outcome: 'error', message: error }
}

function casesOf(check: MeshCheck, options: JunitOptions): Case[] {
  const { hexahedra, invalid, below, unanswered, notTrilinear } = check
  const isInvalid = (cell: number) => check.standingOf(cell) === 'invalid'
  const isBelow = (cell: number) => check.standingOf(cell) !== 'unanswered' && check.isBelow(cell)
  const cases: Case[] = [
    { name: 'the file is read', outcome: 'passed' },
    {
      name: 'no hexahedron is invalid',
      ...(invalid > 0
        ? {
            outcome: 'failure',
            message: `${invalid} of ${counted(hexahedra, 'hexahedron', 'hexahedra')} invalid`,
            details: detailsOf(check, isInvalid),
          }
        : { outcome: 'passed' }),
    },
  ]
  if (options.minRelative !== null)
    cases.push({
      name: `no relative minimum is below ${options.minRelative}`,
      ...(below > 0
        ? {
            outcome: 'failure',
            message: `${below} of ${counted(hexahedra, 'hexahedron', 'hexahedra')} below`,
            details: detailsOf(check, isBelow),
          }
        : { outcome: 'passed' }),
    })
  cases.push({
    name: 'every hexahedron is answered',
    ...(isWhollyAnswered(check)
      ? { outcome: 'passed' }
      : {
          outcome: options.allowsUnchecked ? 'skipped' : 'failure',
          message: `${counted(hexahedra, 'hexahedron', 'hexahedra')}, ${unanswered} unanswered, ${notTrilinear.count} not trilinear`,
        }),
  })
  return cases
}

function detailsOf(check: MeshCheck, isMeant: (cell: number) => boolean): string[] {
  const cells = [...check.worst.subarray(0, MOST_DETAILS)].filter(isMeant)
  return cells.map(cell => detail(check, cell))
}

/** A report is read in a page, and `--worst all` may be a million. */
const MOST_DETAILS = 1000

function detail(check: MeshCheck, cell: number): string {
  const block = check.blockOf(cell)
  const name = `${check.idOf(cell) === null ? `index ${cell}` : `id ${check.idOf(cell)}`}${block === null ? '' : `, block ${block}`}`
  const answer = check.answerTo(cell)
  if ('why' in answer) return `${name}: ${answer.why}`
  const { relativeMinimum, boundaryMinimum, exponent, minimizer } = answer.report
  const relative = relativeMinimum === null ? 'none' : speakNumber(relativeMinimum)
  const minimum = speakJacdet(boundaryMinimum, exponent, 'unit')
  return `${name}: relative minimum ${relative}, minimum ${minimum} at ${minimizer.kind} ${minimizer.id}`
}

function caseText(file: string, { name, outcome, message = '', details = [] }: Case): string {
  const head = `<testcase classname="${markup(file)}" name="${markup(name)}"`
  if (outcome === 'passed') return `${head}/>\n`
  return `${head}><${outcome} message="${markup(message)}">${markup(details.join('\n'))}</${outcome}></testcase>\n`
}
