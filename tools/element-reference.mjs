// The reference of the element and of its documents, for tools and for people: custom-elements.json
// and docs/element.md from web/element/interface.json, docs/*.schema.json from the readers.
// --check: complains of the files that are not as they would be written.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { isScript, root, runMain } from './run.mjs'

const SOURCE = 'web/element/interface.json'

/** Names of the files that are not up to date; written unless only checked. */
export async function elementReference({ check }) {
  const element = JSON.parse(readFileSync(join(root, SOURCE), 'utf8'))
  const texts = { 'custom-elements.json': manifest(element), 'docs/element.md': page(element), ...(await schemas()) }
  const stale = Object.keys(texts).filter(name => textOf(name) !== texts[name])
  if (!check) for (const name of stale) writeFileSync(join(root, name), texts[name])
  return stale
}

function textOf(name) {
  try {
    return readFileSync(join(root, name), 'utf8')
  } catch {
    return null
  }
}

/** Readers of documents know their JSON Schemas. A server, since panels bring their style sheets along. */
async function schemas() {
  const { createServer } = await import('vite') // not before it is installed
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'silent',
    server: { middlewareMode: true, ws: false },
  })
  const { stateJsonSchema, challengeJsonSchema } = await server.ssrLoadModule('/web/pages/schemas.ts')
  await server.close()
  return { 'docs/state.schema.json': json(stateJsonSchema), 'docs/challenge.schema.json': json(challengeJsonSchema) }
}

const json = value => `${JSON.stringify(value, null, 2)}\n`

/** A manifest of version 2.1.0: https://github.com/webcomponents/custom-elements-manifest. */
function manifest(element) {
  const described = ({ name, text, default: value }) => ({
    name,
    ...entry('description', text),
    ...entry('default', value),
  })
  const reflected = new Set(element.attributes.map(({ name }) => name))
  const members = [
    ...element.properties.map(({ name, type, text, readonly }) => ({
      kind: 'field',
      name,
      type: { text: type },
      ...entry('description', text),
      ...entry('readonly', readonly),
      ...entry('attribute', reflected.has(name.toLowerCase()) && name.toLowerCase()),
    })),
    ...element.methods.map(({ name, parameters, returns, text }) => ({
      kind: 'method',
      name,
      description: text,
      parameters: parameters.map(({ name, type, default: value }) => ({
        name,
        type: { text: type },
        optional: true,
        default: value,
      })),
      return: { type: { text: returns } },
    })),
  ]
  const declaration = {
    kind: 'class',
    customElement: true,
    name: 'HexLens',
    tagName: element.tag,
    summary: element.summary,
    superclass: { name: 'HTMLElement' },
    attributes: element.attributes.map(({ type, ...attribute }) => ({ ...described(attribute), type: { text: type } })),
    members,
    events: element.events.map(({ name, detail, text }) => ({
      name,
      type: { text: detail === 'null' ? 'CustomEvent<null>' : `CustomEvent<${detail}>` },
      description: text,
    })),
    slots: element.slots.map(described),
    cssParts: element.parts.map(described),
    cssProperties: element.customProperties.map(described),
  }
  const path = 'dist/hexlens.es.js'
  const module = {
    kind: 'javascript-module',
    path,
    declarations: [declaration],
    exports: [
      { kind: 'js', name: 'HexLens', declaration: { name: 'HexLens', module: path } },
      { kind: 'custom-element-definition', name: element.tag, declaration: { name: 'HexLens', module: path } },
    ],
  }
  return `${JSON.stringify({ schemaVersion: '2.1.0', modules: [module] }, null, 2)}\n`
}

function entry(key, value) {
  return value ? { [key]: value } : {}
}

function page(element) {
  const { attributes, properties, methods, events, slots, parts, customProperties } = element
  const code = text => `\`${text}\``
  const call = ({ name, parameters }) => code(`${name}(${parameters.map(({ name }) => `${name}?`).join(', ')})`)
  return [
    `# \`<${element.tag}>\``,
    element.summary,
    'For authors who put the element into their pages: every name it understands. `docs/embedding.md` has the first steps.',
    `Written by \`npm run reference\` from \`${SOURCE}\`.`,
    '## Attributes',
    table(
      ['attribute', 'takes', 'without it', ''],
      attributes.map(a => [code(a.name), a.type, a.default, a.text]),
    ),
    '## Properties',
    table(
      ['property', 'type', ''],
      properties.map(p => [code(p.name) + (p.readonly ? ', read only' : ''), code(p.type), p.text]),
    ),
    '## Methods',
    table(
      ['method', 'gives', ''],
      methods.map(m => [call(m), code(m.returns), m.text]),
    ),
    '## Events',
    'They bubble, out of shadow trees too.',
    table(
      ['event', 'detail', ''],
      events.map(e => [code(e.name), code(e.detail), e.text]),
    ),
    '## Slots',
    table(
      ['slot', ''],
      slots.map(s => [s.name === '' ? 'between the tags' : code(s.name), s.text]),
    ),
    '## CSS parts',
    table(
      ['part', ''],
      parts.map(p => [code(p.name), p.text]),
    ),
    '## Custom properties',
    table(
      ['property', 'without it', ''],
      customProperties.map(p => [code(p.name), p.default, p.text]),
    ),
    '## Its box',
    'The element is a block of a fixed box: as wide as its place, as high as `--hl-aspect-ratio` says, or as `height` or `aspect-ratio` do in the page’s style. So that nothing moves when the script arrives, the page says the same in its own style sheet:',
    '    hex-lens { display: block; aspect-ratio: 4 / 3 }',
  ]
    .join('\n\n')
    .concat('\n')
}

function table(head, rows) {
  const line = cells => `| ${cells.map(cell => cell.replaceAll('|', '\\|')).join(' | ')} |`
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n')
}

if (isScript(import.meta.url)) {
  await runMain(async () => {
    const { check } = parseArgs({ options: { check: { type: 'boolean', default: false } } }).values
    const stale = await elementReference({ check })
    for (const name of stale)
      process.stdout.write(`${name} ${check ? 'is not up to date: npm run reference' : 'written'}\n`)
    return check && stale.length > 0 ? 1 : 0
  })
}
