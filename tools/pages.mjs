// The pages of the app, which the build makes, and what it writes into each: the only place that lists them.

/** `file` is in web/pages, without its .html; `hasFont` if the page loads one. */
export const appPages = [
  { file: 'index', name: 'Lens' },
  { file: 'mesh', name: 'Mesh' },
  { file: 'lessons', name: 'Lessons', hasFont: true },
  { file: 'challenges', name: 'Challenges' },
  { file: 'search', name: 'Search' },
  { file: 'gallery', name: 'Gallery' },
]

/** The app's page at a path of the build; undefined if it is none. */
export function pageAt(path) {
  return appPages.find(({ file }) => path.endsWith(`/${file}.html`))
}

const head = `
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <meta name="theme-color" content="#fcfcfb" media="(prefers-color-scheme: light)" />
    <meta name="theme-color" content="#17181a" media="(prefers-color-scheme: dark)" />
    <link rel="icon" href="/favicon.svg" type="image/svg+xml" />
    <link rel="preload" href="../../build/hexlens.wasm" as="fetch" type="application/wasm" crossorigin />`

/** The lens's content until its script has come. */
const words = `
        <p class="late">
          Hexlens could not start: its script did not arrive or this browser is too old to run it. Reloading may help.
        </p>
        <noscript><p>Hexlens draws and computes in the browser: it needs JavaScript.</p></noscript>
      `

/**
 * Writes head, words and links before the build looks for the files that they name.
 *
 * @type {import('vite').Plugin}
 */
export const pages = {
  name: 'hexlens-pages',
  transformIndexHtml: {
    order: 'pre',
    handler(source, { path }) {
      const present = pageAt(path)
      if (!present) return source
      const html = withInserted(withInserted(source, /<head>/, head), /<hex-lens [^>]*>/, words)
      return { html, tags: [linksOn(present)] }
    },
  },
}

function withInserted(html, after, text) {
  if (!after.test(html)) throw new Error(`There is no ${after} in the page.`)
  return html.replace(after, found => found + text)
}

/** @returns {import('vite').HtmlTagDescriptor} */
function linksOn(present) {
  const links = appPages.map(({ file, name }) => {
    const address = { href: file === 'index' ? './' : `./${file}.html` }
    const attrs = name === present.name ? { ...address, 'aria-current': 'page' } : address
    return { tag: 'li', children: [{ tag: 'a', attrs, children: name }] }
  })
  return {
    tag: 'nav',
    attrs: { class: 'pages', 'aria-label': 'Hexlens' },
    children: [{ tag: 'ul', children: links }],
    injectTo: 'body-prepend',
  }
}
