/** The processor time of this process in milliseconds: unlike the clock, other work on the machine does not change it much. */
export function processorTime(): number {
  const { user, system } = process.cpuUsage()
  return (user + system) / 1000
}
