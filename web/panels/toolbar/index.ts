import type { Panel } from '../panel'
import { createToolbar, toolbarStyles } from './toolbar'

export const toolbar: Panel = { name: 'toolbar', region: 'head', create: createToolbar, styles: toolbarStyles }
