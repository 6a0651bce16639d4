import type { HexLens } from 'hexlens/svelte'
import type { SvelteHTMLElements } from 'svelte/elements'

/** As a template is checked: `<hex-lens vertices={…} onhex-change={…}>`. */
export const props: SvelteHTMLElements['hex-lens'] = {
  vertices: [0, 1],
  readonly: true,
  class: 'wide',
  'onhex-probe': ({ detail }) => detail?.jacdet.toFixed(3),
}
export const undone = (lens: HexLens) => lens.undo()
// @ts-expect-error There is no such attribute.
export const wrong: SvelteHTMLElements['hex-lens'] = { colour: 'red' }
