/**
 * `hexlens/light`: `<hex-lens>` with the scene and the verdict alone, in two thirds of the bytes. Other words in `views` are refused by a
 * sentence, and nothing is read from texts and files. Everything else is the same element.
 */
import './core-inside' // first, as in hexlens.ts
import { define } from '../element/define'
import type { HexLens as Element } from '../element/hex-lens'
import { announcer } from '../panels/announcer'
import { problems } from '../panels/problems'
import { verdict } from '../panels/verdict'
import { scene } from '../scene/scene'
import { say } from '../words/say'
import { coreInside } from './core-inside'
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

/** The registered class, whichever copy of a script has brought it. */
export const HexLens = define({
  core: coreInside,
  panels: [problems, announcer, verdict, scene],
  readingWorker: () => Promise.reject(new Error(say('the light file of Hexlens has no readers'))),
})
export type HexLens = Element
