/** `npm run test:exact` draws all, `npm test` a hundredth. HEXLENS_SEED draws others. */
export const isWhole = process.env.HEXLENS_EXACT === 'whole'

export function scaled(count: number): number {
  return isWhole ? count : count / 100
}

/** Against hanging only. */
export const TIMEOUT = 7_200_000

/** Prints a line in test:exact, where somebody reads it. */
export function report(line: string): void {
  if (isWhole) process.stdout.write(`${line}\n`)
}
