/** Whether a key is for a field or for the lens, so that it does nothing else on the page. */
export function isTyping({ target }: KeyboardEvent): boolean {
  return target instanceof HTMLElement && target.matches('input, textarea, select, hex-lens')
}
