// A Vite plugin: shaders without comments and spare white space, templates of lit-html with one
// space where the source has a line's end. Nothing that is drawn or shown changes: the compiler
// does not read these, and HTML shows white space of any length as one space.

/** @type {import('vite').Plugin} */
export const leanText = {
  name: 'hexlens-lean-text',
  apply: 'build',
  enforce: 'pre',
  transform: {
    filter: { id: /\/web\/.*\.ts$/, code: /\/\* glsl \*\/|\b(?:html|svg|mathml)`/ },
    async handler(code) {
      const { parseAst } = await import('vite') // not before it is installed
      const edits = []
      visit(parseAst(code, { lang: 'ts' }), node => {
        const isMarkup = node.type === 'TaggedTemplateExpression' && /^(?:html|svg|mathml)$/.test(node.tag.name)
        if (isMarkup) edits.push(...ofMarkup(node.quasi.quasis, code))
      })
      const lean = edits
        .sort((a, b) => b.start - a.start)
        .reduce((text, { start, end, by }) => text.slice(0, start) + by + text.slice(end), code)
      return { code: lean.replace(/(?<=\/\* glsl \*\/ `)[^`]*/g, shader), map: null }
    },
  },
}

function visit(node, onNode) {
  onNode(node)
  for (const value of Object.values(node))
    for (const child of Array.isArray(value) ? value : [value])
      if (typeof child?.type === 'string') visit(child, onNode)
}

/** Values of attributes, and what stands between the tags of `pre` and `textarea`, keep their ends of lines. */
function ofMarkup(parts, code) {
  const edits = []
  let quote = ''
  let isTag = false
  for (const { start, end } of parts)
    for (let at = start; at < end; at++) {
      const character = code[at]
      if (quote !== '') quote = character === quote ? '' : quote
      else if (isTag && /["']/.test(character)) quote = character
      else if (character === '>') isTag = false
      else if (character === '<') isTag = /[\w/!]/.test(code[at + 1])
      else if (/\s/.test(character)) {
        const [blank] = /^\s+/.exec(code.slice(at, end))
        if (blank.includes('\n')) edits.push({ start: at, end: at + blank.length, by: ' ' })
        at += blank.length - 1
      }
    }
  return edits
}

/** Two signs in a row are not one operator, so that these keep their spaces. */
function shader(source) {
  return source
    .replace(/\/\/.*$/gm, '')
    .replace(/\s+/g, ' ')
    .replace(/ ?([{}()[\];,=*/<>?:&|!]) ?/g, '$1')
}
