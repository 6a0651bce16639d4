import type { Panel } from '../panel'
import { createAnnouncer } from './announcer'

export const announcer: Panel = { name: 'announcer', region: 'head', create: createAnnouncer, styles: '', always: true }
