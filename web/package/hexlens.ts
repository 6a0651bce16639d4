/** The package's element: importing it defines `<hex-lens>`. */
export { HexLens } from '../element/hex-lens'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'
export { setMeshWorker } from './mesh-worker-beside'
