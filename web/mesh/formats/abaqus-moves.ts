/** Abaqus: a translation and a rotation as two data lines, of an instance or a copy. */
import type { Rotation, Vector } from './movement'
import type { TextLines } from './text-lines'

/** The numbers of one line. */
export function moveLine(lines: TextLines): number[] {
  lines.splitAtCommas()
  return Array.from({ length: Math.max(lines.fieldCount, 7) }, (_, i) => lines.real(i))
}

/** The move that the lines under the keyword in line `line` are. */
export function moveOf(
  moveLines: readonly number[][],
  lines: TextLines,
  line: number,
): { translation: Vector; rotation: Rotation | null } {
  const [shift = [], turn] = moveLines
  if (moveLines.length > 2 || shift.slice(3).some(value => value !== 0))
    lines.refuse('a move is a line of 3 numbers and, for a rotation, one of 7.', line)
  const vector = (list: readonly number[], from: number): Vector => [
    list[from] ?? 0,
    list[from + 1] ?? 0,
    list[from + 2] ?? 0,
  ]
  return {
    translation: vector(shift, 0),
    rotation:
      turn && (turn[6] ?? 0) !== 0 ? { from: vector(turn, 0), to: vector(turn, 3), degrees: turn[6] ?? 0 } : null,
  }
}
