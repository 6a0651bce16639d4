/** The element as the pages have it: with the search for the nearest element, which comes when its panel is opened. */
import { coreFiles } from '../core/core-files'
import { define } from '../element/define'
import { panels } from '../panels/list'
import { morph } from '../panels/morph'
import { nearest } from '../panels/nearest'

define({
  core: coreFiles,
  panels: panels.toSpliced(panels.indexOf(morph), 0, nearest),
  readingWorker: async () => (await import('../input/worker-file')).startReadingWorker,
})
