/** The step in history that a key asks for (Ctrl or Cmd with Z, Shift+Z or Y), else null. */
export function historyStep(event: KeyboardEvent): 'undo' | 'redo' | null {
  if (event.altKey || !(event.ctrlKey || event.metaKey)) return null
  const key = event.key.toLowerCase()
  if (key === 'z') return event.shiftKey ? 'redo' : 'undo'
  return key === 'y' && event.ctrlKey ? 'redo' : null
}

/** True for a question mark, unless it is typed into a field or already handled. */
export function asksForHelp(event: KeyboardEvent): boolean {
  const isTyping = (event.target as Element).matches('input, textarea, select')
  return event.key === '?' && !isTyping && !event.defaultPrevented
}
