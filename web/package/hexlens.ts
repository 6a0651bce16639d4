/** The package's element: importing it defines `<hex-lens>`, with all but the panels that only the pages have. */
import './core-inside' // first: gzip finds more likeness in code that the wasm does not part
import { define } from '../element/define'
import { panels } from '../panels/list'
import { coreInside } from './core-inside'
import { readingWorkerBeside } from './mesh-worker-beside'

export type { Report } from '../core/report'
export type { HexLensEventMap, ProbeDetail } from '../element/events'
export { HexLens } from '../element/hex-lens'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'
export type { MotionOptions } from '../element/motion'
export type { CameraGoal, HighlightedParts } from '../element/script-arguments'
export type { HistoryDocument } from '../model/history-document'
export type { CameraView } from '../model/state'
export type { StateDocument } from '../model/state-document'
export type { SceneState } from '../views/scene-slices'
export type { FigureName, Problem } from '../views/view'
export type { HexLensAttributes } from './authors'
export { setMeshWorker } from './mesh-worker-beside'

define({ core: coreInside, panels, otherPanels: ['nearest'], readingWorker: readingWorkerBeside })

/** lit-html has noted its version in a global list; a guest leaves nothing behind. */
const { litHtmlVersions: noted } = globalThis as { litHtmlVersions?: string[] }
noted?.pop()
if (noted?.length === 0) Reflect.deleteProperty(globalThis, 'litHtmlVersions')
