/** One file has no worker's file beside it: long texts are read on the page, which waits for them. */
export function startReadingWorker(): Worker | null {
  return null
}
