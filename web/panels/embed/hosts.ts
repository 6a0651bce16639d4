/** Snippets for each kind of documentation: for the site once, and for each element. */

import { encodePermalink } from '../../model/permalink'
import { pointsOf } from '../../model/written-element'
import type { PlainWord } from '../../words/say'
import { attributesOf, type Embed, elementMarkup, escaped } from './embed-lines'

export interface Snippet {
  /** The name of the file that it goes into, or words. */
  readonly place: PlainWord
  /** The name that fences of Markdown have for it. */
  readonly language: string
  readonly text: string
}

export interface Host {
  readonly id: string
  readonly title: string
  /** True if the site's program cannot be installed where the tests run. */
  readonly untested?: true
  /** Snippets for a site: the file to copy, and the lines that load it. */
  readonly setup: readonly Snippet[]
  /** The snippet of one element. */
  snippet(embed: Embed): Snippet
}

/** The box grows beyond the height by what the reader opens. */
const STYLE = ({ height }: Embed) => `style="display: block; min-height: ${height}px; --hl-aspect-ratio: auto"`

function indented(text: string, by: string): string {
  return text.replace(/^(?=.)/gm, by)
}

/** The picture is a file beside the page that shows it. */
const html = (place: PlainWord) => (embed: Embed) => ({
  place,
  language: 'html',
  text: elementMarkup(embed, STYLE(embed)),
})

const sphinxSetup: Snippet = {
  place: 'conf.py',
  language: 'python',
  text: 'html_static_path = ["_static"]\nhtml_js_files = [("hexlens.iife.js", {"defer": "defer"})]',
}

/** Sphinx copies nothing that raw HTML names. */
function inStatic(embed: Embed): Embed {
  return { ...embed, poster: `_static/${embed.poster}` }
}

export const hosts: readonly [Host, ...Host[]] = [
  {
    id: 'html',
    title: 'HTML',
    setup: [{ place: 'in the head', language: 'html', text: '<script defer src="hexlens.iife.js"></script>' }],
    snippet: html('in the body'),
  },
  {
    id: 'iframe',
    title: 'iframe',
    setup: [
      {
        place: 'once on the page',
        language: 'html',
        text: [
          '<script>',
          "  addEventListener('message', ({ data, source }) => {",
          "    if (data?.type !== 'hexlens-resize') return",
          "    for (const frame of document.querySelectorAll('iframe'))",
          `      if (frame.contentWindow === source) frame.style.height = data.height + 'px'`,
          '  })',
          '</script>',
        ].join('\n'),
      },
    ],
    snippet: embed => {
      const query = new URLSearchParams(attributesOf(embed).map(([name, value]) => [name, value]))
      const address = `hexlens/embed.html?${query}#${encodePermalink(embed.vertices)}`
      return {
        place: 'in the body',
        language: 'html',
        text: [
          '<iframe',
          `  src="${escaped(address)}"`,
          `  title="${escaped(embed.label)}"`,
          '  loading="lazy"',
          `  style="width: 100%; height: ${embed.height}px; border: 0"`,
          '></iframe>',
        ].join('\n'),
      }
    },
  },
  {
    id: 'sphinx',
    title: 'Sphinx',
    setup: [sphinxSetup],
    snippet: embed => ({
      place: 'in a page, index.rst',
      language: 'rst',
      text: `.. raw:: html\n\n${indented(elementMarkup(inStatic(embed), STYLE(embed)), '   ')}`,
    }),
  },
  {
    id: 'myst',
    title: 'MyST in Sphinx',
    setup: [{ ...sphinxSetup, text: `extensions = ["myst_parser"]\n${sphinxSetup.text}` }],
    snippet: embed => ({
      place: 'in a page, index.md',
      language: 'markdown',
      text: `\`\`\`{raw} html\n${elementMarkup(inStatic(embed), STYLE(embed))}\n\`\`\``,
    }),
  },
  {
    id: 'mkdocs',
    title: 'MkDocs',
    setup: [
      { place: 'mkdocs.yml', language: 'yaml', text: 'extra_javascript:\n  - path: hexlens.iife.js\n    defer: true' },
    ],
    snippet: embed => ({
      place: 'in a page, index.md',
      language: 'markdown',
      text: `<div>\n${elementMarkup(embed, STYLE(embed))}\n</div>`,
    }),
  },
  {
    id: 'mdx',
    title: 'MDX',
    setup: [{ place: 'at the top of the page, page.mdx', language: 'mdx', text: "import 'hexlens'" }],
    snippet: embed => ({
      place: 'in the page',
      language: 'mdx',
      text: elementMarkup(
        embed,
        `style={{ display: 'block', minHeight: ${embed.height}, '--hl-aspect-ratio': 'auto' }}`,
      ),
    }),
  },
  {
    id: 'quarto',
    title: 'Quarto',
    untested: true,
    setup: [
      {
        place: 'at the top of the page, page.qmd',
        language: 'yaml',
        text: [
          '---',
          'resources: [hexlens.iife.js]',
          'format:',
          '  html:',
          '    include-in-header:',
          '      text: \'<script defer src="hexlens.iife.js"></script>\'',
          '---',
        ].join('\n'),
      },
    ],
    snippet: embed => ({
      place: 'in the page',
      language: 'markdown',
      text: `\`\`\`{=html}\n${elementMarkup(embed, STYLE(embed))}\n\`\`\``,
    }),
  },
  {
    id: 'jupyter',
    title: 'Jupyter',
    setup: [{ place: 'in a cell', language: 'python', text: 'from hexlens import HexLens' }],
    snippet: ({ vertices, views, height }) => ({
      place: 'in the next cell',
      language: 'python',
      text: [
        'lens = HexLens(',
        '    [',
        ...pointsOf(vertices).map(point => `        [${point.map(pythonNumber).join(', ')}],`),
        '    ],',
        `    views="${views.join(' ')}",`,
        `    height=${height},`,
        ')',
        'lens',
      ].join('\n'),
    }),
  },
]

/** Whole numbers stay short: NumPy makes doubles of them; but a bare -0 is Python's integer 0. */
function pythonNumber(value: number): string {
  return Object.is(value, -0) ? '-0.0' : String(value)
}
