/** The element as the pages have it: with the search for the nearest element and best places, which come when their panels are opened. */
import { coreFiles } from '../core/core-files'
import { define } from '../element/define'
import { bestPlace } from '../panels/best-place'
import { panels } from '../panels/list'
import { morph } from '../panels/morph'
import { nearest } from '../panels/nearest'

define({
  core: coreFiles,
  panels: panels.toSpliced(panels.indexOf(morph), 0, nearest, bestPlace),
  readingWorker: async () => (await import('../input/worker-file')).startReadingWorker,
})
