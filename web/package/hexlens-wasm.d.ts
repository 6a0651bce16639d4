/** build/hexlens.wasm as base64 of its bytes in zlib's format; tools/package.mjs makes it. */
declare module 'virtual:hexlens.wasm.deflated' {
  const base64: string
  export default base64
}
