/** An element of the page as a figure: its canvases, SVG and short texts, with their styles in attributes, as they are now. */
import { placeIn } from '../../views/place-in'
import type { Figure, PixelLayer, VectorLayer } from '../../views/view'

/** The styles that a reader of the file needs to draw the shapes alike; the rest is inherited or never set. */
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

/** The elements in `root` that are on the screen, in the order given; one that is neither canvas nor SVG is taken as a line of text. */
export function figureOf(root: HTMLElement, elements: Iterable<Element>): Figure {
  const outer = sizeOf(root)
  const layers = [...elements].flatMap(element => {
    const { width, height } = sizeOf(element)
    // The middle of what is seen is that of the element, however it is turned.
    const seen = element.getBoundingClientRect()
    const middle = placeIn(root, { clientX: seen.x + seen.width / 2, clientY: seen.y + seen.height / 2 })
    const isShown = middle && width > 0 && height > 0 && getComputedStyle(element).visibility !== 'hidden'
    if (!isShown) return []
    const box = { x: middle.x * outer.width - width / 2, y: middle.y * outer.height - height / 2, width, height }
    return [layerOf(element, box)]
  })
  return {
    ...outer,
    background: getComputedStyle(root.closest('.lens') ?? root).backgroundColor,
    layers,
  }
}

/** Without transforms; 0 of what is not displayed. */
function sizeOf(element: Element): { readonly width: number; readonly height: number } {
  const { width, height } = getComputedStyle(element)
  return { width: Number.parseFloat(width) || 0, height: Number.parseFloat(height) || 0 }
}

type Box = Pick<PixelLayer, 'x' | 'y' | 'width' | 'height'>

function layerOf(element: Element, box: Box): PixelLayer | VectorLayer {
  if (element instanceof HTMLCanvasElement) return { ...box, canvas: copyOf(element) }
  return { ...box, markup: element instanceof SVGSVGElement ? styledMarkup(element, box) : textMarkup(element, box) }
}

/** Made at once, while the picture is still there. */
export function copyOf(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const copy = document.createElement('canvas')
  copy.width = canvas.width
  copy.height = canvas.height
  copy.getContext('2d')?.drawImage(canvas, 0, 0)
  return copy
}

function styledMarkup(element: SVGSVGElement, box: Box): string {
  const copy = element.cloneNode(true) as SVGSVGElement
  const [shown, copied] = [element, copy].map(root => [root, ...root.querySelectorAll('*')])
  shown?.forEach((original, i) => {
    const target = copied?.[i] as Element
    const style = getComputedStyle(original)
    for (const attribute of ['class', 'tabindex']) target.removeAttribute(attribute)
    if (style.display === 'none' || original.matches('.cue')) target.remove()
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
    // A file refers to no document but itself.
    if (value !== '') target.setAttribute(name, value.replace(/url\("?[^#"]*(#[^")]*)"?\)/, 'url($1)'))
  }
}

function textMarkup(element: Element, { x, y, width, height }: Box): string {
  const style = getComputedStyle(element)
  const text = document.createElementNS('http://www.w3.org/2000/svg', 'text')
  text.textContent = (element.textContent ?? '').trim()
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
