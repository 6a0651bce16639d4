/** How much is drawn: all of it by `npm run test:exact`, a hundredth in `npm test`. HEXLENS_SEED draws others. */
export const isWhole = process.env.HEXLENS_EXACT === 'whole'

export function scaled(count: number): number {
  return isWhole ? count : count / 100
}

/** Against hanging only. */
export const TIMEOUT = 7_200_000

/** Of test:exact, which is read. */
export function report(line: string): void {
  if (isWhole) process.stdout.write(`${line}\n`)
}
