/** The command line: which command is meant, and its exit status. web/cli/from-sources.ts and web/package/cli.ts run it. */

import { version } from '../../package.json'
import { shown, withoutControls } from '../mesh/text-cursor'
import { Refusal } from '../model/result'
import { certification } from '../outputs/certificates'
import { analysis } from './analysis'
import { check } from './check'
import { type AnswerTo, answerElements } from './elements'
import type { Engine } from './engine'
import { repair } from './repair'
import { processStreams, type Streams } from './streams'
import { CALL, CHECK_USAGE, REPAIR_USAGE, USAGE } from './usage'

export type { Streams } from './streams'

/** Commands that answer for each element of a list. */
const elementCommands = new Map<string, AnswerTo>([
  ['analyze', analysis],
  ['certify', certification],
])

/** Commands for files of meshes, which have options. */
const meshCommands = new Map([
  ['check', { run: check, usage: CHECK_USAGE }],
  ['repair', { run: repair, usage: REPAIR_USAGE }],
])

const OK = 0
const REFUSED = 2

/** Runs one command; resolves to the exit status, 2 for a wrong call or input; `check` and `repair` have others. */
export async function main(
  args: readonly string[],
  engine: Engine,
  streams: Streams = processStreams(),
): Promise<number> {
  const [name = '', ...rest] = args
  try {
    if (isHelp(name) || (elementCommands.has(name) && isHelp(rest[0]))) {
      await streams.output.write(USAGE)
      return OK
    }
    if (name === '--version') {
      await streams.output.write(`${version}\n`)
      return OK
    }
    const meshCommand = meshCommands.get(name)
    if (meshCommand) {
      if (!rest.some(isHelp)) return await meshCommand.run(rest, engine, streams)
      await streams.output.write(meshCommand.usage)
      return OK
    }
    const answerTo = elementCommands.get(name)
    const [file, ...more] = rest
    if (answerTo !== undefined && file !== undefined && more.length === 0) {
      await answerElements(answerTo, file, engine, streams)
      return OK
    }
    if (name !== '' && answerTo === undefined)
      throw new Refusal(`There is no command ${shown(name)}. ${CALL} --help says what there is.`)
    streams.errors.write(USAGE)
    return REFUSED
  } catch (error) {
    if (!(error instanceof Refusal)) throw error
    streams.errors.write(`hexlens: ${withoutControls(error.message)}\n`)
    return REFUSED
  }
}

function isHelp(argument: string | undefined): boolean {
  return argument === '--help' || argument === '-h'
}
