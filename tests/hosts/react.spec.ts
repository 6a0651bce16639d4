/** React 19 in strict mode. */
import { snippetsOf } from '../package/documentation'
import { testFramework } from './framework'

const page = `import { createElement, StrictMode, useState } from 'react'
import { Lens } from './lens.jsx'

export function Page() {
  const [isIn, setIsIn] = useState(true)
  const button = createElement('button', { type: 'button', onClick: () => setIsIn(!isIn) }, 'In and out')
  return createElement(StrictMode, null, button, isIn ? createElement(Lens) : null)
}
`

testFramework({
  name: 'React',
  folder: 'react',
  package: 'react',
  files: () => ({
    'vite.config.js': 'export default {}\n',
    'lens.jsx': snippetsOf('React')[0] as string,
    'page.js': page,
    'server.js':
      "import { createElement } from 'react'\nimport { renderToString } from 'react-dom/server'\nimport { Page } from './page.js'\nexport const page = renderToString(createElement(Page))\n",
    'client.js':
      "import { createElement } from 'react'\nimport { hydrateRoot } from 'react-dom/client'\nimport { Page } from './page.js'\nhydrateRoot(document.getElementById('root'), createElement(Page))\n",
  }),
})
