import { createScene, prepareScene, sceneStyles } from '../../scene/scene'
import type { Panel } from '../panel'

export const scene: Panel = {
  name: 'scene',
  place: 'stage',
  create: createScene,
  styles: sceneStyles,
  prepare: prepareScene,
}
