// One setup at a time: a second one waits for the first.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { isAlive } from './run.mjs'

/** Runs `work` while holding the lock file, which names the process that holds it. */
export async function withLock(file, say, work) {
  mkdirSync(dirname(file), { recursive: true })
  let said = false
  while (!acquire(file)) {
    if (!said) say(`setup: waiting for another setup to end (if there is none, remove ${file})`)
    said = true
    await new Promise(resolve => setTimeout(resolve, 200))
  }
  const release = () => rmSync(file, { force: true })
  process.on('exit', release)
  try {
    return await work()
  } finally {
    process.off('exit', release)
    release()
  }
}

function acquire(file) {
  try {
    writeFileSync(file, `${process.pid}\n`, { flag: 'wx' })
    return true
  } catch (error) {
    if (error.code !== 'EEXIST') throw error
  }
  if (isHeld(file)) return false
  rmSync(file, { force: true })
  return acquire(file)
}

function isHeld(file) {
  try {
    const holder = Number(readFileSync(file, 'utf8'))
    // A file without a number yet is being written.
    return !holder || isAlive(holder)
  } catch {
    return false
  }
}
