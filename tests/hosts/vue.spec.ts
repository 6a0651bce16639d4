/** Vue 3. */
import { snippetsOf } from '../package/documentation'
import { testFramework } from './framework'

const page = `<script setup>
import { ref } from 'vue'
import Lens from './Lens.vue'

const isIn = ref(true)
</script>

<template>
  <button type="button" @click="isIn = !isIn">In and out</button>
  <Lens v-if="isIn" />
</template>
`

testFramework({
  name: 'Vue',
  folder: 'vue',
  package: 'vue',
  files: () => {
    const [config, lens] = snippetsOf('Vue') as [string, string]
    return {
      'vite.config.js': config,
      'Lens.vue': lens,
      'Page.vue': page,
      'server.js':
        "import { createSSRApp } from 'vue'\nimport { renderToString } from 'vue/server-renderer'\nimport Page from './Page.vue'\nexport const page = renderToString(createSSRApp(Page))\n",
      'client.js':
        "import { createSSRApp } from 'vue'\nimport Page from './Page.vue'\ncreateSSRApp(Page).mount('#root')\n",
    }
  },
})
