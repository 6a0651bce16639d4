/** JSON Schemas of the documents that people write; tools/element-reference.mjs puts them into docs/. */

import { historySchema } from '../model/history-document'
import { stateSchema } from '../model/state-document'
import { bestPlace } from '../panels/best-place'
import { panels } from '../panels/list'
import { nearest } from '../panels/nearest'
import { knownPanels } from '../panels/panel'
import { challengeSchema } from './challenges/challenge'
import { seriesSchema } from './challenges/series'

const DIALECT = { $schema: 'https://json-schema.org/draft/2020-12/schema' }
const FOR_EVER =
  'Version 1 is read for ever: keys may be added to it, and a reader ignores keys that it does not know. A later version is refused.'

export const stateJsonSchema = {
  ...DIALECT,
  title: 'State of a <hex-lens> element, version 1',
  description: `What \`element.state\` gives and takes. ${FOR_EVER} A missing key means what a new element shows. Panels that a reader does not know are ignored.`,
  ...stateSchema(knownPanels([...panels, nearest, bestPlace])),
}

export const historyJsonSchema = {
  ...DIALECT,
  title: 'History of a <hex-lens> element, version 1',
  description: `What \`element.history\` gives and takes: the elements that undo and redo lead to. ${FOR_EVER}`,
  ...historySchema(),
}

export const challengeJsonSchema = {
  ...DIALECT,
  title: 'A challenge of Hexlens, version 1',
  description: `What \`challenges.html#own=\` and percent-encoded JSON opens. ${FOR_EVER} The whole is at most 8000 characters long. Texts are plain text: what looks like HTML is refused.`,
  ...challengeSchema,
}

export const seriesJsonSchema = {
  ...DIALECT,
  title: 'A series of challenges of Hexlens, version 1',
  description: `What \`challenges.html#series=\` opens: JSON, deflated without a header (RFC 1951), in base64url. ${FOR_EVER} Texts are plain text: what looks like HTML is refused.`,
  ...seriesSchema,
}
