// Who imports whom: down only, and never round. A type counts like a value.

import { readdirSync, readFileSync, statSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { root } from './run.mjs'

/** From top to bottom. A path belongs to the longest of these that it begins with, and imports from its own line and those below. */
const LAYERS = [
  ['web/app', 'web/cli', 'web/package'],
  ['web/element'],
  ['web/panels'],
  ['web/views'],
  ['web/scene'],
  ['web/scene/input'],
  ['web/scene/overlay'],
  ['web/scene/paint'],
  ['web/scene/space'],
  ['web/views/view.ts'],
  ['web/search', 'web/core', 'web/content', 'web/mesh', 'web/model'],
]

const IMPORT = /\b(?:from|import|URL)\s*\(?\s*(['"])(\.[^'"?]+)(?:\?[^'"]*)?\1/g

/** Lines of complaint about the files of a folder: imports that go up, and circles. */
export function importComplaints(folder) {
  const graph = importsOf('web')
  const isJudged = file => file.startsWith(folder)
  const round = circles(graph).filter(files => files.some(isJudged))
  return [...upward(graph, isJudged), ...round.map(files => `a circle: ${files.join(' -> ')}`)]
}

/** Each source file with the files that it imports. */
function importsOf(folder) {
  const names = readdirSync(join(root, folder), { recursive: true }).map(name => join(folder, name))
  const sources = names.filter(name => /\.(ts|css)$/.test(name))
  return new Map(
    sources.map(name => {
      const text = readFileSync(join(root, name), 'utf8')
      const targets = [...text.matchAll(IMPORT)].map(([, , path]) => fileOf(join(dirname(name), path)))
      return [name, targets.filter(target => target?.startsWith(folder))]
    }),
  )
}

/** As TypeScript resolves it. */
function fileOf(path) {
  return [path, `${path}.ts`, join(path, 'index.ts')].find(name =>
    statSync(join(root, name), { throwIfNoEntry: false })?.isFile(),
  )
}

function upward(graph, isJudged) {
  const judged = [...graph].filter(([from]) => isJudged(from))
  return judged.flatMap(([from, targets]) =>
    targets.filter(to => layerOf(to) < layerOf(from)).map(to => `${from} imports ${to}, which is above it`),
  )
}

function layerOf(file) {
  const names = LAYERS.flat().filter(name => file === name || file.startsWith(`${name}/`))
  const longest = names.reduce((best, name) => (name.length > best.length ? name : best), '')
  return LAYERS.findIndex(names => names.includes(longest))
}

/** Each circle once, from the first of its files that is met. */
function circles(graph) {
  const found = []
  const state = new Map()
  const visit = (file, path) => {
    if (state.get(file) === 'done') return
    if (state.get(file) === 'open') {
      found.push([...path.slice(path.indexOf(file)), file])
      return
    }
    state.set(file, 'open')
    for (const target of graph.get(file) ?? []) visit(target, [...path, file])
    state.set(file, 'done')
  }
  for (const file of graph.keys()) visit(file, [])
  return found
}
