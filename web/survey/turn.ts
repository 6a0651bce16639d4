const channel = new MessageChannel()
const waiting: (() => void)[] = []
channel.port2.onmessage = () => waiting.shift()?.()

/** Lets messages come in, and others who wait for a turn. */
export function turn(): Promise<void> {
  return new Promise(resolve => {
    waiting.push(resolve)
    channel.port1.postMessage(null)
  })
}
