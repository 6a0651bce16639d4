/** build/hexlens-twin.js, which wasm2js writes without types. */
declare module '*/hexlens-twin.js' {
  export const memory: import('./core').CoreExports['memory']
  export const _initialize: () => void
  export const input_address: () => number
  export const input_length: () => number
  export const output_address: () => number
  export const output_length: () => number
  export const analyze: () => number
  export const boundary_minimum: (variant: number) => number
  export const decide: () => number
  export const jacobian_at: () => number
}
