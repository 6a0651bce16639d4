/** Coordinates that people can read: decimal steps for dragging, the keyboard and the grid, exact in decimal. */

/** A step of `digits` x 10^exponent. */
export interface Step {
  readonly digits: 1 | 25
  readonly exponent: number
}

const LEAST_EXPONENT = -323

/** The step of a drag, given the length of a pixel: the power of ten at or below it. */
export function roundingStep(lengthPerPixel: number): Step {
  return { digits: 1, exponent: decade(lengthPerPixel) }
}

/** The step of an arrow key: a hundredth of the element, to the nearest power of ten. */
export function keyStep(extent: number): Step {
  return { digits: 1, exponent: Math.max(LEAST_EXPONENT, Math.round(Math.log10(extent) - 1.7)) }
}

/** The grid of Alt: the coarsest of 1, 1/4 and their powers of ten that divides the element in ten or more. */
export function gridStep(extent: number): Step {
  const tenth = extent / 10
  const exponent = decade(tenth)
  const fine: Step = { digits: 1, exponent }
  const middle: Step = { digits: 25, exponent: Math.max(LEAST_EXPONENT, exponent - 1) }
  return tenth / lengthOf(fine) >= 2.5 ? middle : fine
}

export function lengthOf({ digits, exponent }: Step): number {
  return Number(`${digits}e${exponent}`)
}

/** Numbers of steps beyond this are not whole numbers apart any more: the coordinate is finer than the step already. */
const MOST_STEPS = 2 ** 52

/** The nearest multiple of the step, as the double that its decimal notation names. */
export function roundTo(value: number, step: Step): number {
  const count = Math.round(value / lengthOf(step))
  if (!(Math.abs(count) < MOST_STEPS / 25)) return value
  return Number(`${count * step.digits}e${step.exponent}`) || 0
}

/** A sum without the dust of binary fractions: 0.1 + 0.2 is 0.3. */
export function addDecimal(value: number, amount: number): number {
  const sum = value + amount
  if (!Number.isFinite(sum)) return value
  return Number(sum.toPrecision(15))
}

function decade(length: number): number {
  if (!(length > 0)) return LEAST_EXPONENT
  const exponent = Math.floor(Math.log10(Math.min(length, Number.MAX_VALUE)))
  return Math.max(LEAST_EXPONENT, exponent)
}
