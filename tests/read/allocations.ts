/** Counts what typed arrays are given while a file is read: the largest and the sum, in bytes. To be imported before the readers. */

export const allocations = { largest: 0, sum: 0 }

const NAMES = [
  'Uint8Array',
  'Int8Array',
  'Uint16Array',
  'Int16Array',
  'Uint32Array',
  'Int32Array',
  'Float32Array',
  'Float64Array',
  'BigInt64Array',
  'BigUint64Array',
] as const

type Make = new (...args: never[]) => { readonly byteLength: number }

for (const name of NAMES) {
  const original = globalThis[name] as unknown as Make & { BYTES_PER_ELEMENT: number }
  Object.defineProperty(globalThis, name, {
    configurable: true,
    writable: true,
    value: new Proxy(original, {
      construct(target, args, self) {
        const [first] = args
        // An array counts even where there is no memory for it; a view of a buffer is no allocation.
        if (typeof first === 'number') count(target.BYTES_PER_ELEMENT * first)
        else if (!(first instanceof ArrayBuffer))
          count(target.BYTES_PER_ELEMENT * ((first as never[] | undefined)?.length ?? 0))
        return Reflect.construct(target, args, self)
      },
    }),
  })
}

function count(bytes: number): void {
  allocations.largest = Math.max(allocations.largest, bytes)
  allocations.sum += bytes
}
