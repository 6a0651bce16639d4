/**
 * The package's element: importing it defines `<hex-lens>`, with all but the panels that only the pages have. `hexlens/three` is the
 * same without three.js: it pays on a page that has three.js of the same version, and nowhere else.
 */
import './core-inside' // first: gzip finds more likeness in code that the wasm does not part
import { define } from '../element/define'
import type { HexLens as Element } from '../element/hex-lens'
import { panels } from '../panels/list'
import { coreInside } from './core-inside'
import { readingWorkerBeside } from './mesh-worker-beside'
import './no-trace'

export type { Report } from '../core/report'
export type { GivenVertices } from '../element/attributes'
export type { ChangeDetail } from '../element/changes'
export type { HexLensEventMap, ProbeDetail } from '../element/events'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'
export type { MotionOptions } from '../element/motion'
export type { CameraGoal, HighlightedParts } from '../element/script-arguments'
export type { HistoryDocument } from '../model/history-document'
export type { CameraView, ChangeSource } from '../model/state'
export type { StateDocument } from '../model/state-document'
export type { SceneState } from '../views/scene-slices'
export type { FigureName, Problem } from '../views/view'
export type { HexLensAttributes } from './authors'
export { setMeshWorker } from './mesh-worker-beside'

/** The registered class, whichever copy of the script has brought it. */
export const HexLens = define({
  core: coreInside,
  panels,
  otherPanels: ['nearest'],
  readingWorker: readingWorkerBeside,
})
export type HexLens = Element
