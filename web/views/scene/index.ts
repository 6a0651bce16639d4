import type { Panel } from '../../panels/panel'
import { createScene, prepareScene, sceneStyles } from './scene'

export const sceneView: Panel = {
  name: 'scene',
  place: 'stage',
  create: createScene,
  styles: sceneStyles,
  prepare: prepareScene,
}
