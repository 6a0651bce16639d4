import type { Panel } from '../panel'
import { createVertices, verticesStyles } from './vertices'

export const vertices: Panel = { name: 'vertices', region: 'panel', create: createVertices, styles: verticesStyles }
