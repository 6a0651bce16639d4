import type { Panel } from '../panel'
import { checksStyles, createChecks } from './checks'

export const checks: Panel = { name: 'checks', region: 'panel', create: createChecks, styles: checksStyles }
