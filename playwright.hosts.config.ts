/** `npm run test:hosts`: the element in foreign hosts, which the project's own tests do not install. */
import { defineConfig } from '@playwright/test'
import own from './playwright.config'

export default defineConfig<{ pictureRatio: number }>({
  ...own,
  projects: [{ name: 'hosts', testDir: 'tests/hosts' }],
  reporter: [...(own.reporter as [string][]), ['./tests/hosts/table.ts']],
  // Hosts take a core each to be installed and built.
  workers: 2,
  // Pictures as readers see them: they are kept in build/hosts/pictures, to be looked at.
  use: { ...own.use, pictureRatio: 1 },
})
