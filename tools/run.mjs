// Child processes and failures as the tools in this folder share them. Plain Node: this runs before any package is installed.

import { spawn } from 'node:child_process'
import { accessSync, constants, realpathSync, statSync } from 'node:fs'
import { delimiter, join } from 'node:path'
import { fileURLToPath } from 'node:url'

export const root = fileURLToPath(new URL('..', import.meta.url)).replace(/[\\/]$/, '')

export const biome = join(root, 'node_modules', '@biomejs', 'biome', 'bin', 'biome')
export const tsc = join(root, 'node_modules', 'typescript', 'bin', 'tsc')

/** A failure with a sentence on what to do; printed without a stack. */
export class Failure extends Error {}

const children = new Set()
let endWith

// A child that goes on alone would work against the next run, so it is waited for.
for (const [signal, status] of [
  ['SIGINT', 130],
  ['SIGTERM', 143],
]) {
  process.on(signal, () => {
    endWith = status
    if (children.size === 0) process.exit(status)
    for (const child of children) child.kill(signal)
    setTimeout(() => {
      for (const child of children) child.kill('SIGKILL')
      process.exit(status)
    }, 5000)
  })
}

function ended(child) {
  children.delete(child)
  if (endWith !== undefined && children.size === 0) process.exit(endWith)
}

/**
 * Runs a command without a terminal to ask questions on. `output`: 'capture' keeps both streams, 'show' passes them
 * on, 'tee' does both.
 * Resolves to { status, stdout, text }: `text` is both streams as they came; status is 127 when it could not start.
 */
export function run(command, args, { cwd = root, env = process.env, output = 'capture' } = {}) {
  const stdio = {
    capture: ['ignore', 'pipe', 'pipe'],
    show: ['ignore', 'inherit', 'inherit'],
    tee: ['ignore', 'pipe', 'pipe'],
  }
  return new Promise(resolve => {
    const child = spawn(command, args, { cwd, env, stdio: stdio[output] })
    children.add(child)
    let stdout = ''
    let text = ''
    child.stdout?.setEncoding('utf8').on('data', chunk => {
      stdout += chunk
      text += chunk
      if (output === 'tee') process.stdout.write(chunk)
    })
    child.stderr?.setEncoding('utf8').on('data', chunk => {
      text += chunk
      if (output === 'tee') process.stderr.write(chunk)
    })
    child.on('error', error => {
      ended(child)
      resolve({ status: 127, stdout, text: text + error.message })
    })
    child.on('close', (code, signal) => {
      ended(child)
      resolve({ status: code ?? 1, stdout, text: signal ? `${text}\nended by ${signal}` : text })
    })
  })
}

/** Like `run`, captured; when the command fails throws a Failure with the tail of its output and the advice. */
export async function must(command, args, advice, options) {
  const result = await run(command, args, options)
  if (result.status !== 0) throw new Failure(failedCommand([command, ...args], result, advice))
  return result
}

/** The message for a failed command: its name, the ends of its output, what to do. */
export function failedCommand(command, { status, text }, advice) {
  const lines = text.trim().split('\n')
  const shown = lines.length > 30 ? [...lines.slice(0, 10), '[...]', ...lines.slice(-20)] : lines
  return [`This command failed (status ${status}): ${command.join(' ')}`, ...shown, advice].filter(Boolean).join('\n')
}

/** The absolute path of an executable file, or undefined. */
export function executable(path) {
  try {
    accessSync(path, constants.X_OK)
    return statSync(path).isFile() ? path : undefined
  } catch {
    return undefined
  }
}

/** The first of the names that is found on PATH, as an absolute path, or undefined. */
export function onPath(...names) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean)
  for (const name of names) {
    for (const folder of folders) {
      const path = executable(join(folder, name))
      if (path) return path
    }
  }
  return undefined
}

/** True while a process has this id. */
export function isAlive(id) {
  try {
    process.kill(id, 0)
    return true
  } catch (error) {
    return error.code === 'EPERM'
  }
}

/** Runs a tool's main and turns what it throws into a message and exit status 1. */
export async function runMain(main) {
  try {
    process.exitCode = (await main()) ?? 0
  } catch (error) {
    process.stderr.write(`${error instanceof Failure ? error.message : error.stack}\n`)
    process.exitCode = 1
  }
}

/** True when the module is the script that node was started with. */
export function isScript(url) {
  return process.argv[1] !== undefined && fileURLToPath(url) === realpathSync(process.argv[1])
}
