/** Starlight, of Astro: the last one that runs in Node 20. */
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { testGuest } from './guest'
import { installed, npmVersion, putFiles, run } from './host'

const FILES = {
  'astro.config.mjs': `import starlight from '@astrojs/starlight'
import { defineConfig } from 'astro/config'
export default defineConfig({
  site: 'https://example.org',
  base: '/starlight/dist',
  integrations: [starlight({ title: 'A site', pagefind: false })],
  image: { service: { entrypoint: 'astro/assets/services/noop' } },
  build: { format: 'file' },
})
`,
  'src/content.config.ts': `import { defineCollection } from 'astro:content'
import { docsLoader } from '@astrojs/starlight/loaders'
import { docsSchema } from '@astrojs/starlight/schema'
export const collections = { docs: defineCollection({ loader: docsLoader(), schema: docsSchema() }) }
`,
}

testGuest({
  name: 'Starlight',
  version: () => npmVersion('starlight', '@astrojs/starlight'),
  build: () => {
    const folder = installed('starlight')
    const [component, page] = snippetsOf('Starlight') as [string, string]
    for (const name of ['src/content/docs', 'src/components']) mkdirSync(join(folder, name), { recursive: true })
    for (const [name, text] of Object.entries(FILES)) writeFileSync(join(folder, name), text)
    writeFileSync(join(folder, 'src/components/HexLens.astro'), `${component}\n`)
    writeFileSync(join(folder, 'src/content/docs/page.mdx'), `---\ntitle: A page\n---\n\n${page}\n`)
    putFiles(join(folder, 'public'))
    run(folder, 'env', 'ASTRO_TELEMETRY_DISABLED=1', 'astro', 'build')
  },
  address: 'starlight/dist/page.html',
  turn: async (page, scheme) => {
    await page.locator('starlight-theme-select select').filter({ visible: true }).first().selectOption(scheme)
  },
})
