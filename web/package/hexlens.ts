/** The package's element: importing it defines `<hex-lens>`, with all but the panels that only the pages have. */
import './core-inside' // first: gzip finds more likeness in code that the wasm does not part
import { define } from '../element/define'
import { panels } from '../panels/list'
import { coreInside } from './core-inside'
import { readingWorkerBeside } from './mesh-worker-beside'

export { HexLens } from '../element/hex-lens'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'
export { setMeshWorker } from './mesh-worker-beside'

define({ core: coreInside, panels, otherPanels: ['nearest'], readingWorker: readingWorkerBeside })

/** lit-html has noted its version in a global list; a guest leaves nothing behind. */
const { litHtmlVersions: noted } = globalThis as { litHtmlVersions?: string[] }
noted?.pop()
if (noted?.length === 0) Reflect.deleteProperty(globalThis, 'litHtmlVersions')
