/** The module behind bundlers. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { expectDocumented } from './guest'
import { html, installed, npmVersion, onceInRun, putFiles, run, test } from './host'

/** What each bundler is told to make `NAME/page.js` of `page.js`. */
const bundlers = {
  esbuild: 'esbuild page.js --bundle --minify --format=esm --outfile=esbuild/page.js --log-level=error',
  rollup: 'rollup page.js --silent --plugin node-resolve --format es --dir rollup',
  webpack: 'node webpack.js',
  vite: 'vite build --logLevel error',
}

const WEBPACK = `import webpack from 'webpack'
const output = { path: new URL('webpack', import.meta.url).pathname, filename: 'page.js' }
webpack({ mode: 'production', entry: './page.js', output, performance: false }, (error, stats) => {
  if (error || stats.hasErrors() || stats.hasWarnings()) throw error ?? new Error(stats.toString())
})
`

const VITE = `export default {
  build: { outDir: 'vite', lib: { entry: 'page.js', formats: ['es'], fileName: () => 'page.js' } },
}
`

test.beforeAll(async () => {
  test.setTimeout(600_000)
  await onceInRun('bundlers', () => {
    const folder = installed('bundlers')
    const write = (name: string, text: string) => writeFileSync(join(folder, name), text)
    write('page.js', "import 'hexlens'\n")
    write('webpack.js', WEBPACK)
    write('vite.config.js', VITE)
    for (const [name, command] of Object.entries(bundlers)) {
      const [program, ...words] = command.split(' ') as [string, ...string[]]
      run(folder, program, ...words)
      putFiles(join(folder, name))
      const body = snippetsOf('HTML')[1] as string
      write(`${name}/index.html`, html('<script type="module" src="page.js"></script>', body))
    }
  })
})

for (const name of Object.keys(bundlers))
  test(`behind ${name}`, async ({ lens }) => {
    test.info().annotations.push({ type: 'host', description: `${name}\t${npmVersion('bundlers', name)}` })
    await lens.open(`bundlers/${name}/index.html`)
    await expectDocumented(lens)
  })
