/** An element to embed elsewhere, and the markup that the hosts' snippets share. */

import type { Vertices } from '../../model/hexahedron'
import { numberText } from '../../model/number-text'
import type { CameraView } from '../../model/state'
import { pointsOf } from '../../model/written-element'
import type { PlainWord } from '../../words/say'
import type { Choice } from './choice'

/** Names of panels in the attribute `views`, in their order. */
export const embeddableViews = [
  { name: 'scene', title: 'Scene' },
  { name: 'verdict', title: 'Verdict' },
  { name: 'checks', title: 'Who would notice' },
  { name: 'proof', title: 'Proof' },
  { name: 'vertices', title: 'Vertices' },
  { name: 'face-maps', title: 'Face maps' },
  { name: 'algorithm', title: 'Algorithm 1' },
  { name: 'inside', title: 'Inside' },
  { name: 'morph', title: 'Morph' },
  { name: 'node-order', title: 'Node order' },
  { name: 'paste', title: 'Paste or drop' },
  { name: 'take-away', title: 'Take away' },
  { name: 'toolbar', title: 'Presets, undo' },
] as const satisfies readonly { readonly name: string; readonly title: PlainWord }[]

export interface Embed extends Omit<Choice, 'host' | 'label'> {
  readonly vertices: Vertices
  /** The text for screen readers, and in the picture's place. */
  readonly label: string
  /** The address that opens the element, for readers without JavaScript. */
  readonly link: string
  /** File name of the picture that stands for it until it runs, or if it does not. */
  readonly poster: string
}

/** The page that the link is of, if one of the views has a link. */
export function appOf({ views, link }: Pick<Embed, 'views' | 'link'>): string | null {
  const hasLinks = views.includes('toolbar') || views.includes('take-away')
  return hasLinks ? link.replace(/#.*/, '') : null
}

/** The attributes besides `vertices` that differ from the defaults. */
export function attributesOf(embed: Embed): readonly (readonly [string, string])[] {
  const { views, theme, readonly, camera, label } = embed
  const app = appOf(embed)
  return [
    ['label', label] as const,
    ...(views.join(' ') === 'scene verdict' ? [] : [['views', views.join(' ') || 'none'] as const]),
    ...(camera === null ? [] : [['camera', camera] as const]),
    ...(theme === 'auto' ? [] : [['theme', theme] as const]),
    ...(readonly ? [['readonly', ''] as const] : []),
    ...(app === null ? [] : [['app', app] as const]),
  ]
}

/** The element, a link and a picture for readers without JavaScript; `style` has its height. */
export function elementMarkup(embed: Embed, style: string): string {
  const attributes = attributesOf(embed).map(([name, value]) => (value === '' ? name : `${name}="${escaped(value)}"`))
  return [
    '<hex-lens',
    `  vertices="${verticesText(embed.vertices)}"`,
    ...attributes.map(attribute => `  ${attribute}`),
    `  ${style}`,
    '>',
    `  <a href="${escaped(embed.link)}"><img src="${escaped(embed.poster)}" alt="${escaped(embed.label)}" /></a>`,
    '</hex-lens>',
  ].join('\n')
}

/** Azimuth and elevation in whole tenths of a degree, and the zoom, as the attribute says them. */
export function cameraText({ direction: [x, y, z], zoom }: CameraView): string {
  const degrees = (radians: number) => Number(((radians * 180) / Math.PI).toFixed(1))
  const elevation = Math.atan2(z, Math.hypot(x, y))
  return `${degrees(Math.atan2(y, x))} ${degrees(elevation)} ${Number(zoom.toPrecision(3))}`
}

/** Points with commas between, in the shortest decimals that read back as the same doubles. */
export function verticesText(vertices: Vertices): string {
  return pointsOf(vertices)
    .map(point => point.map(numberText).join(' '))
    .join(', ')
}

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }

export function escaped(text: string): string {
  return text.replace(/[&<>"]/g, character => ENTITIES[character] as string)
}
