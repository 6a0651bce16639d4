import type { Action, State } from '../model/state'
import { helpToggled } from '../views/scene-slices'

/** The step in history that a key asks for (Ctrl or Cmd with Z, Shift+Z or Y), else null. */
export function historyStep(event: KeyboardEvent): 'undo' | 'redo' | null {
  if (event.altKey || !(event.ctrlKey || event.metaKey)) return null
  const key = event.key.toLowerCase()
  if (key === 'z') return event.shiftKey ? 'redo' : 'undo'
  return key === 'y' && event.ctrlKey ? 'redo' : null
}

/** The action that a key asks for, else null: a question mark outside fields, or a step in history that there is. */
export function shortcut(event: KeyboardEvent, state: State): Action | null {
  const target = event.target as Element
  if (event.defaultPrevented) return null
  if (event.key === '?' && !target.matches('input, textarea, select')) return helpToggled(state)
  const step = historyStep(event)
  const isMidEdit = state.gestureStart !== null || target.matches('[aria-invalid]')
  if (step === null || isMidEdit || state.isReadonly) return null
  return state[step === 'undo' ? 'canUndo' : 'canRedo'] ? { type: step } : null
}
