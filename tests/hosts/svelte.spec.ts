/** Svelte 5. */
import { snippetsOf } from '../package/documentation'
import { testFramework } from './framework'

const page = `<script>
  import Lens from './Lens.svelte'

  let isIn = $state(true)
</script>

<button type="button" onclick={() => (isIn = !isIn)}>In and out</button>
{#if isIn}<Lens />{/if}
`

testFramework({
  name: 'Svelte',
  folder: 'svelte',
  package: 'svelte',
  files: () => ({
    'vite.config.js': "import { svelte } from '@sveltejs/vite-plugin-svelte'\nexport default { plugins: [svelte()] }\n",
    'Lens.svelte': snippetsOf('Svelte')[0] as string,
    'Page.svelte': page,
    'server.js':
      "import { render } from 'svelte/server'\nimport Page from './Page.svelte'\nexport const page = render(Page).body\n",
    'client.js':
      "import { hydrate } from 'svelte'\nimport Page from './Page.svelte'\nhydrate(Page, { target: document.getElementById('root') })\n",
  }),
})
