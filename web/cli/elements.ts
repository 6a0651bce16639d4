/** `analyze` and `certify`: a JSON list of elements in, a list of answers out, entry by entry, however long the list is. */
import { createReadStream } from 'node:fs'
import type { Core } from '../core/report'
import { Refusal } from '../model/result'
import { jsonList, jsonText } from '../outputs/json-text'
import type { Engine } from './engine'
import { jsonEntries } from './json-entries'
import { type NamedHexahedron, readHexahedron } from './read-hexahedra'
import { Buffered, type Streams } from './streams'

/** The JSON that is printed for one element. */
export type AnswerTo = (core: Core, hexahedron: NamedHexahedron) => object

/** Throws a Refusal; the list is then left open, and nothing is printed where the input is short. */
export async function answerElements(
  answerTo: AnswerTo,
  file: string,
  engine: Engine,
  streams: Streams,
): Promise<void> {
  const core = await engine.core()
  const output = new Buffered(streams.output)
  let count = 0
  for await (const entry of jsonEntries(file === '-' ? streams.input : chunksOf(file))) {
    const answer = jsonText(answerTo(core, readHexahedron(entry, count)))
    await output.write(`${jsonList.before(count++)}${answer}`)
  }
  await output.write(jsonList.end(count))
  await output.flush()
}

const CHUNK = 1024 * 1024

async function* chunksOf(file: string): AsyncGenerator<Buffer> {
  try {
    yield* createReadStream(file, { highWaterMark: CHUNK })
  } catch (error) {
    if (error instanceof Refusal) throw error
    throw new Refusal(`The file ${file} cannot be read (${(error as NodeJS.ErrnoException).code}).`)
  }
}
