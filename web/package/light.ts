/**
 * `hexlens/light`: `<hex-lens>` with the scene and the verdict alone, in two thirds of the bytes. Other words in `views` are refused by a
 * sentence, and nothing is read from texts and files. Everything else is the same element.
 */
import './core-inside' // first, as in hexlens.ts
import { define } from '../element/define'
import { announcer } from '../panels/announcer'
import { problems } from '../panels/problems'
import { verdict } from '../panels/verdict'
import { scene } from '../scene/scene'
import { coreInside } from './core-inside'
import './no-trace'

export { HexLens } from '../element/hex-lens'
export { HexLensError, type HexLensErrorCode } from '../element/hex-lens-error'

define({
  core: coreInside,
  panels: [problems, announcer, verdict, scene],
  readingWorker: () => Promise.reject(new Error('the light file of Hexlens has no readers')),
})
