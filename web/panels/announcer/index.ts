import type { Panel } from '../panel'
import { createAnnouncer } from './announcer'

export const announcer: Panel = { name: 'announcer', place: 'head', create: createAnnouncer, styles: '', always: true }
