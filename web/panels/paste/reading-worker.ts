/** Reads one long text beside the page. */
import { readElements } from '../../model/import/import'

addEventListener('message', ({ data }: MessageEvent<string>) => postMessage(readElements(data)))
