/** The element as the pages have it: with the search for the nearest element, which comes when its panel is opened. */
import { coreFiles } from '../core/core-files'
import { define } from '../element/define'
import { panels } from '../panels/list'
import { nearest } from '../panels/nearest'
import { paste } from '../panels/paste'

define({
  core: coreFiles,
  panels: panels.toSpliced(panels.indexOf(paste), 0, nearest),
  readingWorker: async () => (await import('../input/worker-file')).startReadingWorker,
})
