/** SVG elements made and moved by attributes alone, since the page forbids style attributes. */

const NAMESPACE = 'http://www.w3.org/2000/svg'

export function svg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Readonly<Record<string, string | number>> = {},
  ...children: readonly (Node | string)[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(NAMESPACE, name)
  set(element, attributes)
  element.append(...children)
  return element
}

export function set(element: Element, attributes: Readonly<Record<string, string | number>>): void {
  for (const name in attributes) setAttribute(element, name, String(attributes[name]))
}

/** Reading an attribute costs a tenth of writing it, which the browser takes for a change even if it is none. */
function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value)
}

/** A tenth of a pixel is finer than the eye and keeps the markup short. */
export function px(value: number): string {
  return (Math.round(value * 10) / 10).toString()
}

export function moveTo(element: Element, { x, y }: { readonly x: number; readonly y: number }): void {
  setAttribute(element, 'transform', `translate(${px(x)} ${px(y)})`)
}

export function show(element: Element, shown: boolean): void {
  if (!shown) setAttribute(element, 'display', 'none')
  else if (element.hasAttribute('display')) element.removeAttribute('display')
}

export function setText(element: Element, text: string): void {
  const { firstChild } = element
  if (!(firstChild instanceof Text)) element.textContent = text
  else if (firstChild.data !== text) firstChild.data = text
}
