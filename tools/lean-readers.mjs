// A Vite plugin: readers of documents without the sentences that describe their keys. They are for
// the schemas in docs/, which element-reference.mjs writes from the sources as they are.

const DESCRIPTION = /\bdescribed\(\s*(?:'[^'\n]*'|`[^`]*`)/g

/** @type {import('vite').Plugin} */
export const leanReaders = {
  name: 'hexlens-lean-readers',
  apply: 'build',
  enforce: 'pre',
  transform: {
    filter: { id: /\/web\/.*\.ts$/, code: /\bdescribed\(/ },
    handler: code => ({ code: code.replace(DESCRIPTION, 'described(""'), map: null }),
  },
}
