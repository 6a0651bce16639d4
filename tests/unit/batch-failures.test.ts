/** A promise for a batch never waits for a worker that is no more: real threads that are ended, throw, do not start, or have no memory. */
import { readFileSync } from 'node:fs'
import type { Worker } from 'node:worker_threads'
import { afterAll, expect, it } from 'vitest'
import type { Classification, Classifier } from '../../web/core/batch/classify'
import { randomHexahedron, randomSource } from './core-fixtures'
import { batchCores, endThreads, nodeClassifier } from './node-workers'

afterAll(endThreads)

const CELLS = 3000
const random = randomSource(20260801)
const points = new Float64Array(Array.from({ length: CELLS }, () => randomHexahedron(random, 0.3)).flat())
const expected = batchCores.scalar.classify({ points, cells: null, firstPoint: 0 }, { minima: true })

async function expectAnswer(asked: ReturnType<Classifier['classify']>): Promise<void> {
  const result = await asked
  if (!result.ok) throw new Error(result.error.message)
  expect(result.value.valid).toEqual(expected.valid)
  expect(result.value.minima).toEqual(expected.minima)
}

function ask(classifier: Classifier) {
  return classifier.classify(points, null, { minima: true })
}

/** Ends the thread as anyone in the process can. */
async function kill(thread: Worker | undefined): Promise<void> {
  if (!thread) throw new Error('There is no such thread.')
  await thread.terminate()
}

/** Runs this in the worker when so many pieces have arrived, before its own script hears of the last. */
function onPiece(number: number, action: string): string {
  return `import { parentPort } from 'node:worker_threads'
    let pieces = 0
    parentPort.on('message', ({ kind }) => { if (kind === 'classify' && ++pieces === ${number}) { ${action} } });`
}

/** Says that the piece is there, and then nothing until the thread is ended. */
const stuck = {
  before: onPiece(
    2,
    `parentPort.postMessage({ kind: 'progress', progress: 0 })
    Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0)`,
  ),
}

const first = (what: object) => (number: number) => (number === 0 ? what : {})

it.each([
  {
    how: 'leaves its process',
    worker: { before: onPiece(2, 'process.exit(7)') },
    says: 'A worker for batches ended before it had answered: its thread ended with exit code 7.',
  },
  {
    how: 'throws',
    worker: { before: onPiece(2, "throw new Error('struck by a test')") },
    says: 'A worker for batches ended before it had answered: Error: struck by a test',
  },
  {
    how: 'outgrows its heap',
    worker: {
      before: onPiece(2, 'const all = []; for (;;) all.push(new Array(1e5).fill(0.5))'),
      resourceLimits: { maxOldGenerationSizeMb: 24 },
    },
    says: /^A worker for batches ran out of memory: .*JS heap out of memory$/,
  },
])('the promise rejects where the worker $how, and the next call starts another', async ({ worker, says }) => {
  const classifier = await nodeClassifier(1, { worker: first(worker) })
  await expectAnswer(ask(classifier))
  await expect(ask(classifier)).rejects.toThrow(says)
  await expectAnswer(ask(classifier))
  expect(classifier.threads.length).toBe(2)
  classifier.close()
})

it.each([
  {
    how: 'has a script with a mistake',
    worker: { script: 'this is no script' },
    says: /^A worker for batches did not start: SyntaxError: /,
  },
  {
    how: 'is refused by Node',
    worker: { execArgv: ['--no-such-option'] },
    says: /^A worker for batches did not start: .*--no-such-option/,
  },
])('the promise rejects where the worker $how', async ({ worker, says }) => {
  let asked = 0
  const classifier = await nodeClassifier(1, { worker: () => first(worker)(asked++) })
  await expect(ask(classifier)).rejects.toThrow(says)
  await expectAnswer(ask(classifier))
  expect(asked).toBe(2)
  classifier.close()
})

it('the promise rejects where the worker never says that it has started', async () => {
  const script = "import { parentPort } from 'node:worker_threads'; parentPort.on('message', () => {})"
  const classifier = await nodeClassifier(1, { worker: () => ({ script }), startWithin: 500 })
  const says = 'A worker for batches did not start: it has not answered for 0.5 s.'
  await expect(ask(classifier)).rejects.toThrow(says)
  await expect(ask(classifier)).rejects.toThrow(says)
  expect(classifier.threads.length).toBe(2)
  classifier.close()
})

/** The module, whose memory may grow by so few pages of 64 kB: the greatest size in its memory section is set down. */
async function modestModule(pages: number): Promise<WebAssembly.Module> {
  const bytes = readFileSync(new URL('../../build/hexlens-batch.wasm', import.meta.url))
  let at = 8
  const number = () => {
    let [value, shift] = [0, 0]
    for (;;) {
      const byte = bytes.readUInt8(at++)
      value |= (byte & 127) << shift
      shift += 7
      if (byte < 128) return value
    }
  }
  const MEMORY_SECTION = 5
  for (;;) {
    const section = bytes.readUInt8(at++)
    const end = number() + at
    if (section === MEMORY_SECTION) break
    at = end
  }
  expect([number(), number()], 'one memory, with a greatest size').toEqual([1, 1])
  const greatest = number() + pages
  const from = at
  number()
  for (let i = from; i < at; ++i) bytes.writeUInt8(((greatest >> (7 * (i - from))) & 127) | (i < at - 1 ? 128 : 0), i)
  return WebAssembly.compile(bytes)
}

it('the promise rejects where the wasm has no room to grow, and the next call starts another worker', async () => {
  const classifier = await nodeClassifier(1, { module: await modestModule(2) })
  await expect(ask(classifier)).rejects.toThrow(/^A worker for batches ran out of memory: RangeError: .*grow/)
  const few = await classifier.classify(points.subarray(0, 24 * 10), null)
  expect(few.ok && few.value.valid).toEqual(expected.valid.subarray(0, 10))
  expect(classifier.threads.length).toBe(2)
  classifier.close()
})

const KILLED = 'A worker for batches ended before it had answered: its thread ended with exit code 1.'

it('a thread that is ended from outside takes only its own calls along', async () => {
  const classifier = await nodeClassifier(2, { worker: first(stuck) })
  await Promise.all([expectAnswer(ask(classifier)), expectAnswer(ask(classifier))])
  const lost = classifier.classify(points, null, { onProgress: () => void kill(classifier.threads[0]) })
  const other = ask(classifier)
  await expect(lost).rejects.toThrow(KILLED)
  await expectAnswer(other)
  await Promise.all([expectAnswer(ask(classifier)), expectAnswer(ask(classifier))])
  expect(classifier.threads.length).toBe(3)
  // Idle ones are replaced without a word.
  await Promise.all(classifier.threads.map(kill))
  await expectAnswer(ask(classifier))
  expect(classifier.threads.length).toBe(4)
  classifier.close()
})

it('a call on several threads rejects at once when one of them ends, and says nothing more', async () => {
  const classifier = await nodeClassifier(3, { cellsPerPiece: 50, worker: first(stuck) })
  const later: number[] = []
  let [isOver, isKilled] = [false, false]
  const lost = classifier.classify(points, null, {
    onProgress: ({ done }) => {
      if (isOver) later.push(done)
      if (!isKilled) void kill(classifier.threads[0])
      isKilled = true
    },
  })
  await expect(lost).rejects.toThrow(/its thread ended with exit code [01]\.$/)
  isOver = true
  await expectAnswer(ask(classifier))
  expect(later).toEqual([])
  classifier.close()
})

it.each([false, true])('a stream rejects, too (handed over: %s)', async handOver => {
  const classifier = await nodeClassifier(2, { worker: first({ before: onPiece(3, 'process.exit(1)') }) })
  await expectAnswer(ask(classifier))
  function* chunks() {
    for (let n = 0; n < 40; ++n) yield { points: points.slice() }
  }
  const answers: Classification[] = []
  const read = async () => {
    for await (const result of classifier.stream(chunks(), { minima: true, handOver }))
      if (result.ok) answers.push(result.value)
  }
  await expect(read()).rejects.toThrow(KILLED)
  expect(answers.length).toBeGreaterThan(0)
  expect(answers.length).toBeLessThan(40)
  for (const { valid, minima } of answers) expect([valid, minima]).toEqual([expected.valid, expected.minima])
  await expectAnswer(ask(classifier))
  classifier.close()
})

it('close rejects what is under way, and a call afterwards starts new workers', async () => {
  const classifier = await nodeClassifier(1)
  const lost = ask(classifier)
  classifier.close()
  await expect(lost).rejects.toThrow('The classifier was closed.')
  await expectAnswer(ask(classifier))
  expect(classifier.threads.length).toBe(2)
  classifier.close()
  classifier.close()
})
