/** What stands in for `web/element/page-parts.ts` in the one-file scripts: nothing. */
import type { Part } from '../element/parts'

export const pageParts: readonly Part[] = []
