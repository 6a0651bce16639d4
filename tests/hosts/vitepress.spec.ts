/** VitePress. */
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { click, testGuest } from './guest'
import { installed, npmVersion, putFiles, run } from './host'

testGuest({
  name: 'VitePress',
  version: () => npmVersion('vitepress', 'vitepress'),
  build: () => {
    const folder = installed('vitepress')
    const [config, page] = snippetsOf('VitePress') as [string, string]
    mkdirSync(join(folder, '.vitepress'))
    writeFileSync(join(folder, '.vitepress/author.js'), config)
    writeFileSync(
      join(folder, '.vitepress/config.js'),
      "import author from './author.js'\nexport default { ...author, title: 'A site', base: '/vitepress/dist/', outDir: 'dist' }\n",
    )
    writeFileSync(join(folder, 'page.md'), `# A page\n\n${page}\n`)
    putFiles(join(folder, 'public'))
    run(folder, 'vitepress', 'build', '.')
  },
  address: 'vitepress/dist/page.html',
  turn: click('.VPSwitchAppearance'),
})
