/** What the element shows. A new view is one entry here. */
import { createAnnouncer } from '../views/announcer/announcer'
import { certificateStyles, createCertificate } from '../views/certificate/certificate'
import { checksStyles, createChecks } from '../views/checks/checks'
import { createProblems, problemsStyles } from '../views/problems/problems'
import { createScene, sceneStyles } from '../views/scene/scene'
import { createToolbar, toolbarStyles } from '../views/toolbar/toolbar'
import { createVerdict, verdictStyles } from '../views/verdict/verdict'
import { createVertices, verticesStyles } from '../views/vertices/vertices'
import type { CreateView } from '../views/view'
import { panel } from './panel'

export interface Part {
  readonly place: 'head' | 'stage' | 'panel'
  readonly create: CreateView
  readonly styles: string
  /** Slow to make, a WebGL context for one: it comes a frame after the numbers. */
  readonly slow?: true
}

export const parts: readonly Part[] = [
  { place: 'head', create: createToolbar, styles: toolbarStyles },
  { place: 'head', create: createProblems, styles: problemsStyles },
  { place: 'panel', create: createVerdict, styles: verdictStyles },
  { place: 'panel', create: createCertificate, styles: certificateStyles },
  { place: 'panel', create: createChecks, styles: checksStyles },
  { place: 'panel', create: createVertices, styles: verticesStyles },
  {
    place: 'panel',
    create: panel('face-maps', 'Face maps', () => import('../views/face-maps/face-maps')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('algorithm', 'Algorithm 1, step by step', () => import('../views/algorithm/algorithm')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('inside', 'Inside', () => import('../views/inside-panel/inside-panel')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('node-order', 'Node order', () => import('../views/node-order/node-order')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('morph', 'Morph', () => import('../views/morph/morph')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('paste', 'Paste or drop', () => import('../views/paste/paste')),
    styles: '',
  },
  {
    place: 'panel',
    create: panel('take-away', 'Take away', () => import('../views/take-away/take-away')),
    styles: '',
  },
  { place: 'panel', create: createAnnouncer, styles: '' },
  { place: 'stage', create: createScene, styles: sceneStyles, slow: true },
]
