// The reference of the elements and of their documents, for tools and for people: custom-elements.json
// and docs/*element.md from the comments of their classes and of their events, docs/*.schema.json from
// the readers.
// --check: complains of the files that are not as they would be written.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { isScript, root, runMain } from './run.mjs'

/** What each element's reference is made of; the last of the sources has its class, the others what that extends. */
const ELEMENTS = [
  {
    sources: ['web/element/reflecting-element.ts', 'web/element/hex-lens.ts'],
    events: { source: 'web/element/events.ts', map: 'HexLensEventMap' },
    module: 'dist/hexlens.es.js',
    page: 'docs/element.md',
    more: [
      '## Its box',
      'The element is a block as wide as its place, and 280 to 560 pixels where the place leaves that open: in a flex row, a float, a table cell. It is as high as `--hl-aspect-ratio` says, with a picture at least 22rem, and grows with what is shown. `min-height` makes it higher, and `aspect-ratio` is the page’s to set. With a `height` it scrolls what has no room.',
      'Narrower than 896 pixels, all panels but the verdict are below the picture and closed: **Details** opens them, and the box grows. So that nothing moves when the script arrives, the page says how high the element begins in its own style sheet:',
      '    hex-lens:not(:defined) { display: block; aspect-ratio: 4 / 3; min-height: 22rem }',
      '## Transforms and zoom',
      'Pointers keep to the picture under any `transform`, `perspective`, `zoom` or animation of the element or of what is around it. The picture is drawn as fine as it is seen, up to four times its size. No browser tells of a transform, so it is measured for each new picture; pointing at the element draws one.',
    ],
  },
  {
    sources: ['web/mesh-element/hex-mesh.ts'],
    events: { source: 'web/mesh-element/events.ts', map: 'HexMeshEventMap' },
    module: 'dist/hexlens.hex-mesh.js',
    page: 'docs/mesh-element.md',
    more: [
      '## Its box',
      'The element is a block as wide as its place. Without a `height` the picture is 14rem high and the list 10rem; with one they share what the sentence leaves, three parts to two, and scroll what has no room. So that nothing moves when the mesh arrives, the page gives it a height.',
    ],
  },
]

/** Names of the files that are not up to date; written unless only checked. */
export async function elementReference({ check }) {
  const elements = await Promise.all(ELEMENTS.map(async made => ({ ...made, described: await describedElement(made) })))
  const texts = {
    'custom-elements.json': manifest(elements),
    ...Object.fromEntries(elements.map(element => [element.page, page(element)])),
    ...(await schemas()),
  }
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
  const { stateJsonSchema, historyJsonSchema, challengeJsonSchema, seriesJsonSchema } =
    await server.ssrLoadModule('/web/pages/schemas.ts')
  await server.close()
  return {
    'docs/state.schema.json': json(stateJsonSchema),
    'docs/history.schema.json': json(historyJsonSchema),
    'docs/challenge.schema.json': json(challengeJsonSchema),
    'docs/series.schema.json': json(seriesJsonSchema),
  }
}

const json = value => `${JSON.stringify(value, null, 2)}\n`

/** The class as a manifest declares it, with what is public. */
async function describedElement({ sources, events: { source, map } }) {
  const { create, ts } = await import('@custom-elements-manifest/analyzer') // not before it is installed
  const modules = sources.map(path => ts.createSourceFile(path, textOf(path), ts.ScriptTarget.ESNext, true))
  const { declarations } = create({ modules }).modules.at(-1)
  const { description, members, events: _, ...element } = declarations.find(({ customElement }) => customElement)
  const attributes = new Map(element.attributes.map(({ name }) => [propertyOf(name), name]))
  return withoutLineBreaks({
    ...element,
    superclass: { name: 'HTMLElement' },
    members: members
      .filter(member => member.privacy !== 'private' && !member.static)
      .map(({ inheritedFrom, parameters, ...member }) => ({
        ...member,
        ...(attributes.has(member.name) && { attribute: attributes.get(member.name) }),
        // A default value is code, and the description says it.
        ...(parameters && {
          parameters: parameters.map(({ default: code, ...rest }) => ({
            ...rest,
            optional: rest.optional === true || code !== undefined,
          })),
        }),
      })),
    events: eventsOf(ts.createSourceFile(source, textOf(source), ts.ScriptTarget.ESNext, true), map, ts),
  })
}

/** The property of an attribute, in the case that HTML's own have. */
function propertyOf(attribute) {
  return attribute === 'readonly' ? 'readOnly' : attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase())
}

/** The members of the event map, each with its comment. */
function eventsOf(file, name, ts) {
  const map = file.statements.find(each => ts.isInterfaceDeclaration(each) && each.name.text === name)
  return map.members.map(member => ({
    name: member.name.text,
    type: { text: member.type.getText(file) },
    description: member.jsDoc.at(-1).comment,
  }))
}

function withoutLineBreaks(element) {
  return JSON.parse(JSON.stringify(element).replaceAll('\\n', ' '))
}

/** A manifest of version 2.1.0: https://github.com/webcomponents/custom-elements-manifest. */
function manifest(elements) {
  const modules = elements.map(({ module: path, described }) => {
    const declaration = { name: described.name, module: path }
    return {
      kind: 'javascript-module',
      path,
      declarations: [described],
      exports: [
        { kind: 'js', name: described.name, declaration },
        { kind: 'custom-element-definition', name: described.tagName, declaration },
      ],
    }
  })
  return json({ schemaVersion: '2.1.0', modules })
}

function page({ sources, events: { source }, more, described }) {
  const { tagName, summary, attributes, members, events, slots, cssStates, cssParts, cssProperties } = described
  const code = text => `\`${text}\``
  const call = ({ name, parameters = [] }) =>
    code(`${name}(${parameters.map(({ name, optional }) => name + (optional ? '?' : '')).join(', ')})`)
  return [
    `# \`<${tagName}>\``,
    summary,
    'For authors who put the element into their pages: every name it understands. `docs/embedding.md` has the first steps.',
    `Written by \`npm run reference\` from the comments in \`${sources.at(-1)}\` and \`${source}\`.`,
    '## Attributes',
    table(
      ['attribute', 'takes', 'without it', ''],
      attributes.map(a => [code(a.name), a.type.text, a.default, a.description]),
    ),
    '## Properties',
    table(
      ['property', 'type', ''],
      members
        .filter(({ kind }) => kind === 'field')
        .map(p => [code(p.name) + (p.readonly ? ', read only' : ''), code(p.type.text), p.description]),
    ),
    '## Methods',
    table(
      ['method', 'gives', ''],
      members.filter(({ kind }) => kind === 'method').map(m => [call(m), code(m.return.type.text), m.description]),
    ),
    '## Events',
    'They bubble, out of shadow trees too.',
    table(
      ['event', 'detail', ''],
      events.map(e => [code(e.name), code(e.type.text.slice('CustomEvent<'.length, -1)), e.description]),
    ),
    '## Slots',
    table(
      ['slot', ''],
      slots.map(s => [s.name === '' ? 'between the tags' : code(s.name), s.description]),
    ),
    '## States',
    `For style sheets: \`${tagName}:state(invalid)\`.`,
    table(
      ['state', ''],
      cssStates.map(s => [code(s.name), s.description]),
    ),
    '## CSS parts',
    table(
      ['part', ''],
      cssParts.map(p => [code(p.name), p.description]),
    ),
    '## Custom properties',
    table(
      ['property', 'without it', ''],
      cssProperties.map(p => [code(p.name), p.default, p.description]),
    ),
    ...more,
  ]
    .join('\n\n')
    .concat('\n')
}

function table(head, rows) {
  const line = cells => `| ${cells.map((cell = '') => cell.replaceAll('|', '\\|')).join(' | ')} |`
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
