/** Closes a run with a table: host, version, result, seconds. */
import type { FullConfig, Reporter, Suite } from '@playwright/test/reporter'

interface Row {
  readonly failed: string[]
  tests: number
  seconds: number
}

export default class Table implements Reporter {
  #suite: Suite | undefined

  onBegin(_config: FullConfig, suite: Suite): void {
    this.#suite = suite
  }

  onEnd(): void {
    const rows = new Map<string, Row>()
    for (const test of this.#suite?.allTests() ?? []) {
      const host = test.annotations.find(({ type }) => type === 'host')?.description ?? `${test.parent.title}\t`
      const row = rows.get(host) ?? { failed: [], tests: 0, seconds: 0 }
      rows.set(host, row)
      row.tests++
      row.seconds += test.results.reduce((sum, { duration }) => sum + duration, 0) / 1000
      if (test.outcome() !== 'expected') row.failed.push(test.title)
    }
    const lines = [...rows].map(([host, { failed, tests, seconds }]) => {
      const [name, version] = host.split('\t') as [string, string]
      const result = failed.length === 0 ? 'works' : `${failed.length} of ${tests} failed: ${failed.join('; ')}`
      return [name, version, result, seconds.toFixed(0)]
    })
    process.stdout.write(`\n${table([['host', 'version', 'result', 'seconds'], ...lines])}\n`)
  }
}

function table(rows: readonly string[][]): string {
  const widths = [0, 1].map(column => Math.max(...rows.map(row => (row[column] as string).length)))
  return rows
    .map(([name, version, result, seconds]) =>
      [name?.padEnd(widths[0] as number), version?.padEnd(widths[1] as number), seconds?.padStart(7), result].join(
        '  ',
      ),
    )
    .join('\n')
}
