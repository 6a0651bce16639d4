/** Ctrl or Cmd with Z, Shift+Z or Y: the step in history it asks for, else null. */
export function historyStep(event: KeyboardEvent): 'undo' | 'redo' | null {
  if (event.altKey || !(event.ctrlKey || event.metaKey)) return null
  const key = event.key.toLowerCase()
  if (key === 'z') return event.shiftKey ? 'redo' : 'undo'
  return key === 'y' && event.ctrlKey ? 'redo' : null
}

/** A question mark, unless something is being typed or somebody has answered it. */
export function asksForHelp(event: KeyboardEvent): boolean {
  const isTyping = (event.target as Element).matches('input, textarea, select')
  return event.key === '?' && !isTyping && !event.defaultPrevented
}
