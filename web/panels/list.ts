/** The panels of every element, in their order. Another one is a folder here, and a line. */
import { scene } from '../scene/scene'
import { algorithm } from './algorithm'
import { announcer } from './announcer'
import { checks } from './checks'
import { embed } from './embed'
import { faceMaps } from './face-maps'
import { inside } from './inside'
import { minimum } from './minimum'
import { morph } from './morph'
import { nodeOrder } from './node-order'
import type { Panel } from './panel'
import { paste } from './paste'
import { problems } from './problems'
import { proof } from './proof'
import { reading } from './reading'
import { takeAway } from './take-away'
import { toolbar } from './toolbar'
import { verdict } from './verdict'
import { vertices } from './vertices'

export const panels: readonly Panel[] = [
  toolbar,
  problems,
  announcer,
  reading,
  verdict,
  checks,
  minimum,
  proof,
  vertices,
  faceMaps,
  algorithm,
  inside,
  morph,
  nodeOrder,
  paste,
  takeAway,
  embed,
  scene,
]
