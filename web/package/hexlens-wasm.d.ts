/** Files of build/ as base64 of their bytes in zlib's format; tools/package.mjs makes them. */
declare module 'virtual:*.wasm.deflated' {
  const base64: string
  export default base64
}

/** The script of the workers for batches as text; tools/package.mjs makes it. */
declare module 'virtual:hexlens.batch-worker' {
  const source: string
  export default source
}

/** hexlens.hdf5.js, beside the scripts of the package, which leaves the reader where hdf5-place.ts says. */
declare module 'virtual:hexlens.hdf5'
