// A library without the members that a bundle never asks for. A bundler drops a function that no
// module imports, but keeps every method of a class. Here a method, or a property whose value has
// no effect, goes if nothing in the whole bundle reads its name; a flag such as `isSkinnedMesh` is
// undefined if nothing sets it, and what it guards goes with it. Names are compared, not objects,
// so that doubt keeps a member. A library that makes up names of members must not go through this.

import { createHash } from 'node:crypto'

/** Names that the language or the browser reads. */
const READ_BY_OTHERS = ['constructor', 'handleEvent', 'then', 'toJSON', 'toString', 'valueOf']

const known = new Map()

/** The library's code without what neither it nor the rest of the bundle reads; `flags` are the names that may be undefined. */
export async function withoutUnread(library, rest, flags) {
  const { minifySync, parseAst } = await import('vite') // not before it is installed
  const around = { read: new Set(READ_BY_OTHERS), set: new Set() }
  for (const code of rest) walk(parseAst(code), node => note(node, around))
  const key = keyOf(library, around)
  for (let code = library; !known.has(key); ) {
    const ast = parseAst(code)
    const names = { read: new Set(around.read), set: new Set(around.set), functions: new Set() }
    walk(ast, node => note(node, names))
    const edits = []
    walk(ast, node => {
      const text = isUnread(node, names) ? insteadOf(node) : isUnset(node, names, flags) ? '(void 0)' : null
      if (text !== null) edits.push({ start: node.start, end: node.end, text })
      return text === null
    })
    if (edits.length === 0) known.set(key, code)
    // What only these members read goes in the next round.
    else code = minifySync('library.js', edited(code, edits), READABLE).code
  }
  return known.get(key)
}

const READABLE = { compress: true, mangle: false, codegen: { removeWhitespace: false } }

/** Bundles of one element differ in nothing that a library has: its names decide. */
function keyOf(library, { read, set }) {
  const words = new Set(library.match(/[\w$]+/g))
  const shared = names => [...names].filter(name => words.has(name)).sort()
  return createHash('sha256')
    .update(JSON.stringify([library, shared(read), shared(set)]))
    .digest('hex')
}

/** Adds the names that a node reads and sets, and those of functions. A text may be a name. */
function note(node, { read, set, functions }) {
  switch (node.type) {
    case 'AssignmentExpression':
      if (node.operator === '=') {
        node.left.isTarget = true
        inPattern(node.left)
      }
      break
    case 'ObjectPattern':
      inPattern(node)
      break
    case 'MemberExpression':
      if (!node.computed) (node.isTarget ? set : read).add(node.property.name)
      break
    case 'Property':
      if (!node.computed) (node.isInPattern ? read : set).add(nameOf(node))
      break
    case 'MethodDefinition':
    case 'PropertyDefinition':
      if (!node.computed) set.add(nameOf(node))
      if (node.kind === 'set') read.add(nameOf(node)) // what is assigned arrives there
      break
    case 'FunctionDeclaration':
      functions?.add(node.id?.name)
      break
    case 'Literal':
      if (typeof node.value === 'string') for (const names of [read, set]) names.add(node.value)
      break
  }
}

function inPattern(node) {
  if (node.type === 'ObjectPattern') for (const property of node.properties) property.isInPattern = true
}

const nameOf = ({ key }) => key.name ?? String(key.value)

function isUnread(node, { read, functions }) {
  switch (node.type) {
    case 'MethodDefinition':
      return isNamed(node) && !read.has(node.key.name)
    case 'PropertyDefinition':
      return isNamed(node) && !read.has(node.key.name) && hasNoEffect(node.value)
    case 'ExpressionStatement': {
      const { type, operator, left, right } = node.expression
      return (
        type === 'AssignmentExpression' &&
        operator === '=' &&
        left.type === 'MemberExpression' &&
        !left.computed &&
        left.object.type === 'ThisExpression' &&
        !read.has(left.property.name) &&
        hasNoEffect(right)
      )
    }
    // Objects that go to the browser hold options; functions are handed out to be called.
    case 'Property':
      return isNamed(node) && !node.isInPattern && !read.has(node.key.name) && isFunction(node.value, functions)
  }
  return false
}

/** A statement may be all that an `if` has. */
const insteadOf = ({ type }) => (type === 'ExpressionStatement' ? ';' : '')

const isNamed = ({ computed, key }) => !computed && key.type === 'Identifier'

const isFunction = ({ type, name }, functions) =>
  type === 'FunctionExpression' || (type === 'Identifier' && functions.has(name))

function hasNoEffect(node) {
  switch (node?.type) {
    case undefined:
    case 'ArrowFunctionExpression':
    case 'FunctionExpression':
    case 'Identifier':
    case 'Literal':
      return true
    case 'UnaryExpression':
      return hasNoEffect(node.argument)
    case 'ArrayExpression':
      return node.elements.every(hasNoEffect)
    case 'ObjectExpression':
      return node.properties.every(({ computed, value }) => computed === false && hasNoEffect(value))
  }
  return false
}

function isUnset(node, { set }, flags) {
  return (
    node.type === 'MemberExpression' &&
    isPath(node) &&
    !node.isTarget &&
    flags.has(node.property.name) &&
    !set.has(node.property.name)
  )
}

const isPath = ({ type, computed, object }) =>
  type === 'Identifier' || type === 'ThisExpression' || (type === 'MemberExpression' && !computed && isPath(object))

/** Visits a node, and those in it unless `visit` gives false. */
function walk(node, visit) {
  if (visit(node) === false) return
  for (const value of Object.values(node))
    for (const child of Array.isArray(value) ? value : [value]) if (typeof child?.type === 'string') walk(child, visit)
}

/** Applies edits, in the order of the code and none inside another. A comma goes with the property before it. */
function edited(code, edits) {
  let at = 0
  let result = ''
  for (const { start, end, text } of edits) {
    result += code.slice(at, start) + text
    const comma = text === '' ? /^\s*,/.exec(code.slice(end, end + 100)) : null
    at = end + (comma ? comma[0].length : 0)
  }
  return result + code.slice(at)
}
