/**
 * The package's element: importing it defines `<hex-lens>`, with all but the panels that only the pages have. `hexlens/three` is the
 * same without three.js: it pays on a page that has three.js of the same version, and nowhere else.
 */
import './core-inside' // first: gzip finds more likeness in code that the wasm does not part
import { define } from '../element/define'
import { panels } from '../panels/list'
import { coreInside } from './core-inside'
import { readingWorkerBeside } from './mesh-worker-beside'
import './no-trace'

export { HexLens } from '../element/hex-lens'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'
export { setMeshWorker } from './mesh-worker-beside'

define({ core: coreInside, panels, otherPanels: ['nearest'], readingWorker: readingWorkerBeside })
