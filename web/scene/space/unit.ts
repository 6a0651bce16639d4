/**
 * The scene's own pixel, in which everything in it is laid out: a CSS pixel, or more where the text around it is larger, so that
 * marks and words grow with the text and a figure looks alike on any screen.
 */

/** CSS pixels of the text's size beside which a unit is one of them. */
export const TEXT_SIZE = 14

/** CSS pixels of one unit. */
export function unitOf(element: Element): number {
  return Number.parseFloat(getComputedStyle(element).fontSize) / TEXT_SIZE
}

/** Where a pointer is in an element, from its top left, in units. */
export function placeIn(
  element: Element,
  unit: number,
  { clientX, clientY }: MouseEvent,
): { readonly x: number; readonly y: number } {
  const { left, top } = element.getBoundingClientRect()
  return { x: (clientX - left) / unit, y: (clientY - top) / unit }
}
