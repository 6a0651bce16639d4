// The pages of the app, which the build makes and whose links it writes on top of each: the only place that lists them.

/** `file` is in web/app, without its .html. */
export const appPages = [
  { file: 'index', name: 'Lens' },
  { file: 'lessons', name: 'Lessons' },
  { file: 'challenges', name: 'Challenges' },
  { file: 'search', name: 'Search' },
  { file: 'gallery', name: 'Gallery' },
]

/** @type {import('vite').Plugin} */
export const navigation = {
  name: 'hexlens-navigation',
  transformIndexHtml(_, { path }) {
    const present = appPages.find(({ file }) => path.endsWith(`/${file}.html`))
    return present ? [linksOn(present)] : []
  },
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
