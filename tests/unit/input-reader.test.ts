/** Readings whose worker does not start, ends, or is no longer wanted: real threads, and the sentences about them. */
import { Worker } from 'node:worker_threads'
import { expect, it } from 'vitest'
import { threadPort } from '../../web/core/ports'
import { InputReader, type ReadingWorker } from '../../web/input/input-reader'

const AS_IT_WAS = 'The element is as it was.'

/** A reader of one text, the sentence that refuses it, and the states it goes through. */
function readingWith(worker: ReadingWorker) {
  const news: (string | null)[] = []
  let refuse = (_message: string) => {}
  const refused = new Promise<string>(resolve => {
    refuse = resolve
  })
  const reader = new InputReader(worker, {
    isWelcome: () => true,
    take: vertices => vertices,
    refuse: message => message !== null && refuse(message),
    onNews: () => news.push(reader.reading?.state ?? null),
    onList: () => {},
  })
  reader.read({ text: '0 0 0' })
  return { reader, refused, news }
}

const threadThat = (onJob: string) =>
  new Worker(
    `const { parentPort } = require('node:worker_threads')
    parentPort.on('message', ({ kind }) => {
      if (kind === 'start') parentPort.postMessage({ kind: 'started', lock: null })
      else { ${onJob} }
    })`,
    { eval: true },
  )

it.each([
  { how: 'leaves its process', onJob: 'process.exit(7)', says: 'its thread ended with exit code 7.' },
  { how: 'gives up', onJob: "parentPort.postMessage({ kind: 'failed', message: 'struck' })", says: 'struck.' },
])('a worker that $how refuses the input, and says why', async ({ onJob, says }) => {
  const { refused, news } = readingWith(async () => () => threadPort(threadThat(onJob)))
  const sentence = `Nothing was read: the worker that reads ended before it had answered: ${says} ${AS_IT_WAS}`
  expect(await refused).toBe(sentence)
  expect(news).toEqual([null, 'under-way', 'refused'])
})

it.each([
  { how: 'whose script is nowhere', worker: () => Promise.reject(new Error('it is nowhere')) },
  {
    how: 'that may not be spawned',
    worker: async () => () => {
      throw new Error('it is nowhere')
    },
  },
])('a worker $how refuses it, too', async ({ worker }) => {
  const sentence = `Nothing was read: the worker that reads did not start: it is nowhere. ${AS_IT_WAS}`
  expect(await readingWith(worker).refused).toBe(sentence)
})

it('closing ends the worker, and the reading says nothing more', async () => {
  const stuck = threadThat('Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0)')
  const ended = new Promise(resolve => stuck.on('exit', resolve))
  const { reader, news } = readingWith(async () => () => threadPort(stuck))
  await new Promise(resolve => stuck.once('message', resolve))
  reader.close()
  await ended
  expect(news).toEqual([null, 'under-way', null])
})
