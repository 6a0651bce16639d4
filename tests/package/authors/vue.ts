import type { ChangeDetail, HexLens } from 'hexlens/vue'
import type { GlobalComponents } from 'vue'

/** As a template is checked: `<hex-lens :vertices="…" @hex-change="…">`. */
type Lens = InstanceType<GlobalComponents['hex-lens']>
export const props: Lens['$props'] = { vertices: [0, 1], readonly: true, class: 'wide', views: 'scene' }
export function listen(emit: Lens['$emit'], lens: HexLens, detail: ChangeDetail): void {
  emit('hex-change', new CustomEvent('hex-change', { detail }))
  lens.fit()
}
// @ts-expect-error There is no such attribute.
export const wrong: Lens['$props'] = { colour: 'red' }
