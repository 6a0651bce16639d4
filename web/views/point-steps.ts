/** The step, in [0,1], by which an arrow key moves a point: Shift makes it larger, Alt smaller. */
export function pointStep({ shiftKey, altKey }: KeyboardEvent): number {
  return shiftKey ? 1 / 4 : altKey ? 1 / 64 : 1 / 16
}

export function inUnit(value: number): number {
  return Math.max(0, Math.min(1, value))
}
