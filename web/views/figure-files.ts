/**
 * A figure as a file: vectors over an embedded picture of the coloured faces, or pixels alone. Both
 * contain the vertices: dropped on an element they open them.
 */
import type { Vertices } from '../model/hexahedron'
import { encodePermalink } from '../model/permalink'
import { PNG_KEYWORD, withText } from '../model/png-text'
import type { Figure, PixelLayer } from './view'

/** CSS pixels around an SVG: marks on the border of a figure reach beyond it. */
const MARGIN = 12

/** An SVG document that needs nothing else. */
export function figureSvg(figure: Figure, vertices: Vertices, title: string): string {
  const [width, height] = [figure.width + 2 * MARGIN, figure.height + 2 * MARGIN]
  const box = `x="${-MARGIN}" y="${-MARGIN}" width="${width}" height="${height}"`
  const layers = figure.layers.map(layer => ('markup' in layer ? layer.markup : imageOf(layer)))
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="${-MARGIN} ${-MARGIN} ${width} ${height}">`,
    `<title>${escaped(title)}</title>`,
    `<desc>${escaped(encodePermalink(vertices))}</desc>`,
    `<rect ${box} fill="${escaped(figure.background)}"/>`,
    ...layers,
    '</svg>',
    '',
  ].join('\n')
}

/** At the resolution of the figure's canvas, or twice its size. Rejects without SVG. */
export async function figurePng(figure: Figure, vertices: Vertices): Promise<Blob> {
  const pixels = figure.layers.find((layer): layer is PixelLayer => 'canvas' in layer)
  const ratio = pixels ? pixels.canvas.width / pixels.width : 2
  const canvas = document.createElement('canvas')
  canvas.width = Math.round(figure.width * ratio)
  canvas.height = Math.round(figure.height * ratio)
  const context = canvas.getContext('2d') as CanvasRenderingContext2D
  context.fillStyle = figure.background
  context.fillRect(0, 0, canvas.width, canvas.height)
  context.scale(ratio, ratio)
  for (const layer of figure.layers) {
    if ('canvas' in layer) context.drawImage(layer.canvas, layer.x, layer.y, layer.width, layer.height)
    else context.drawImage(await imageFrom(figure, layer.markup, ratio), 0, 0, figure.width, figure.height)
  }
  const blob = await new Promise<Blob | null>(resolve => canvas.toBlob(resolve, 'image/png'))
  if (blob === null) throw new Error('The browser made no picture.')
  const bytes = new Uint8Array(await blob.arrayBuffer())
  return new Blob([withText(bytes, PNG_KEYWORD, encodePermalink(vertices))], { type: 'image/png' })
}

/** The SVG has no pictures inside: some browsers draw it before these have arrived. */
async function imageFrom({ width, height }: Figure, markup: string, ratio: number): Promise<HTMLImageElement> {
  const size = `width="${width * ratio}" height="${height * ratio}" viewBox="0 0 ${width} ${height}"`
  const text = `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${markup}</svg>`
  const image = new Image()
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`
  await image.decode()
  return image
}

function imageOf({ canvas, x, y, width, height }: PixelLayer): string {
  return `<image x="${x}" y="${y}" width="${width}" height="${height}" href="${canvas.toDataURL('image/png')}"/>`
}

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, character => `&#${character.charCodeAt(0)};`)
}
