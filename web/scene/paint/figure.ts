/** A part of the page as a figure: its canvases, SVG and short texts, with their styles in attributes, as they are now. */
import type { Figure, PixelLayer, VectorLayer } from '../../views/view'

/** What a reader of the file needs to draw the shapes alike; the rest is inherited or never set. */
const STYLES = [
  'fill',
  'fill-opacity',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-linecap',
  'stroke-linejoin',
  'stroke-opacity',
  'opacity',
  'paint-order',
]
const TEXT_STYLES = ['font-family', 'font-size', 'font-weight', 'text-anchor', 'dominant-baseline']

/** Of the parts of `root` that are on the screen, in the order given; text of any other element than these two is taken as a line. */
export function figureOf(root: HTMLElement, parts: Iterable<Element>): Figure {
  const frame = root.getBoundingClientRect()
  const layers = [...parts].flatMap(part => {
    const { left, top, width, height } = part.getBoundingClientRect()
    const isShown = width > 0 && height > 0 && getComputedStyle(part).visibility !== 'hidden'
    const box = { x: left - frame.left, y: top - frame.top, width, height }
    return isShown ? [layerOf(part, box)] : []
  })
  return {
    width: frame.width,
    height: frame.height,
    background: getComputedStyle(root.closest('.lens') ?? root).backgroundColor,
    layers,
  }
}

type Box = Pick<PixelLayer, 'x' | 'y' | 'width' | 'height'>

function layerOf(part: Element, box: Box): PixelLayer | VectorLayer {
  if (part instanceof HTMLCanvasElement) return { ...box, canvas: copyOf(part) }
  return { ...box, markup: part instanceof SVGSVGElement ? styledMarkup(part, box) : textMarkup(part, box) }
}

/** Now, while what was drawn on it is still there. */
export function copyOf(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const copy = document.createElement('canvas')
  copy.width = canvas.width
  copy.height = canvas.height
  copy.getContext('2d')?.drawImage(canvas, 0, 0)
  return copy
}

function styledMarkup(part: SVGSVGElement, box: Box): string {
  const copy = part.cloneNode(true) as SVGSVGElement
  const [shown, copied] = [part, copy].map(root => [root, ...root.querySelectorAll('*')])
  shown?.forEach((original, i) => {
    const target = copied?.[i] as Element
    const style = getComputedStyle(original)
    for (const attribute of ['class', 'tabindex']) target.removeAttribute(attribute)
    if (style.display === 'none') target.remove()
    else if (original instanceof SVGGraphicsElement) setStyles(target, style, original instanceof SVGTextElement)
  })
  for (const [attribute, value] of Object.entries(box)) copy.setAttribute(attribute, String(value))
  if (!copy.hasAttribute('viewBox')) copy.setAttribute('viewBox', `0 0 ${box.width} ${box.height}`)
  copy.setAttribute('overflow', 'visible')
  copy.removeAttribute('aria-hidden')
  return new XMLSerializer().serializeToString(copy)
}

function setStyles(target: Element, style: CSSStyleDeclaration, isText: boolean): void {
  for (const name of isText ? [...STYLES, ...TEXT_STYLES] : STYLES) {
    const value = style.getPropertyValue(name)
    // Its own document is the only one that a file refers to.
    if (value !== '') target.setAttribute(name, value.replace(/url\("?[^#"]*(#[^")]*)"?\)/, 'url($1)'))
  }
}

function textMarkup(part: Element, { x, y, width, height }: Box): string {
  const style = getComputedStyle(part)
  const text = document.createElementNS('http://www.w3.org/2000/svg', 'text')
  text.textContent = (part.textContent ?? '').trim()
  const attributes = {
    x: x + width / 2,
    y: y + height / 2,
    fill: style.color,
    'text-anchor': 'middle',
    'dominant-baseline': 'central',
    'font-family': style.fontFamily,
    'font-size': style.fontSize,
  }
  for (const [attribute, value] of Object.entries(attributes)) text.setAttribute(attribute, String(value))
  return new XMLSerializer().serializeToString(text)
}
