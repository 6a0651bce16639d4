import { fileURLToPath } from 'node:url'
import { defineConfig, type Plugin } from 'vite'
import { leanReaders } from './tools/lean-readers.mjs'
import { leanText } from './tools/lean-text.mjs'
import { leanThree } from './tools/lean-three.mjs'
import { appPages, pageAt, pages } from './tools/pages.mjs'

const root = fileURLToPath(new URL('.', import.meta.url))

const contentSecurityPolicy = (hasFont: boolean) =>
  [
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "style-src 'self'",
    "img-src 'self' data: blob:",
    "connect-src 'self'",
    `font-src ${hasFont ? "'self'" : "'none'"}`,
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ')

/** The policy as the first thing in the built page's head; not in development, whose reloading needs inline scripts. */
const securityPolicy: Plugin = {
  name: 'hexlens-security-policy',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: (_html, { path }) => [
      {
        tag: 'meta',
        attrs: {
          'http-equiv': 'Content-Security-Policy',
          content: contentSecurityPolicy(pageAt(path)?.hasFont ?? false),
        },
        injectTo: 'head-prepend',
      },
    ],
  },
}

export default defineConfig({
  root: `${root}web/pages`,
  base: './',
  appType: 'mpa',
  publicDir: `${root}public`,
  cacheDir: `${root}node_modules/.vite`,
  plugins: [leanThree, leanReaders, leanText, pages, securityPolicy],
  worker: { format: 'es' },
  server: { fs: { allow: [root] } },
  build: {
    target: 'es2022',
    // Browsers with light-dark(): a rewritten one follows no scheme but the one it is declared in.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
    outDir: `${root}dist/app`,
    emptyOutDir: true,
    modulePreload: { polyfill: false },
    // Sizes are judged by npm run check.
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      input: [...appPages.map(({ file }) => file), 'embed'].map(file => `${root}web/pages/${file}.html`),
      checks: { bundlerTimings: false },
    },
    assetsInlineLimit: file => (file.endsWith('.wasm') ? false : undefined),
  },
})
