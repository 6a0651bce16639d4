/** What the element can show. A new view is one entry here, or in `page-parts.ts` if the one-file scripts are to be without it. */
import type { Core } from '../core/report'
import type { State } from '../model/state'
import { createAnnouncer } from '../views/announcer/announcer'
import { certificateStyles, createCertificate } from '../views/certificate/certificate'
import { checksStyles, createChecks } from '../views/checks/checks'
import { createProblems, problemsStyles } from '../views/problems/problems'
import { createReading, readingStyles } from '../views/reading/reading'
import { createScene, prepareScene, sceneStyles } from '../views/scene/scene'
import { createToolbar, toolbarStyles } from '../views/toolbar/toolbar'
import { createVerdict, verdictStyles } from '../views/verdict/verdict'
import { createVertices, verticesStyles } from '../views/vertices/vertices'
import type { CreateView, Frame } from '../views/view'
import { pageParts } from './page-parts'
import { panel } from './panel'

export interface Part {
  /** In the attribute `views`, and as a CSS part. */
  readonly name: string
  /** `folds` are what is closed at first; they follow the panel, or stand beside it where there is room. */
  readonly place: 'head' | 'stage' | 'panel' | 'folds'
  readonly create: CreateView
  readonly styles: string
  /** It is slow to make, and comes after the numbers; this part of it takes a frame of its own. */
  readonly prepare?: () => void
  /** Shown whatever the attribute says. */
  readonly always?: true
  /** Shown where the part of this name is, and not named itself. */
  readonly with?: string
  /** Left out where the element cannot be changed. */
  readonly changes?: true
  /** Of an element: what is asked of the core for this part alone. `onNews` asks for a frame. */
  readonly answers?: (onNews: () => void) => PartAnswers
}

export interface PartAnswers {
  /** What is known by now; nothing that takes long is done meanwhile. */
  of(core: Core, state: State): Partial<Frame>
  stop(): void
}

export const parts: readonly Part[] = [
  { name: 'toolbar', place: 'head', create: createToolbar, styles: toolbarStyles },
  { name: 'problems', place: 'head', create: createProblems, styles: problemsStyles, always: true },
  { name: 'announcer', place: 'head', create: createAnnouncer, styles: '', always: true },
  { name: 'reading', place: 'panel', create: createReading, styles: readingStyles, with: 'paste', changes: true },
  { name: 'verdict', place: 'panel', create: createVerdict, styles: verdictStyles },
  { name: 'proof', place: 'panel', create: createCertificate, styles: certificateStyles },
  { name: 'checks', place: 'panel', create: createChecks, styles: checksStyles },
  { name: 'vertices', place: 'panel', create: createVertices, styles: verticesStyles },
  {
    name: 'face-maps',
    place: 'folds',
    create: panel('face-maps', 'Face maps', () => import('../views/face-maps/face-maps')),
    styles: '',
  },
  {
    name: 'algorithm',
    place: 'folds',
    create: panel('algorithm', 'Algorithm 1, step by step', () => import('../views/algorithm/algorithm')),
    styles: '',
  },
  {
    name: 'inside',
    place: 'folds',
    create: panel('inside', 'Inside', () => import('../views/inside-panel/inside-panel')),
    styles: '',
  },
  {
    name: 'node-order',
    place: 'folds',
    create: panel('node-order', 'Node order', () => import('../views/node-order/node-order')),
    styles: '',
    changes: true,
  },
  {
    name: 'morph',
    place: 'folds',
    create: panel('morph', 'Morph', () => import('../views/morph/morph')),
    styles: '',
    changes: true,
  },
  ...pageParts,
  {
    name: 'paste',
    place: 'folds',
    create: panel('paste', 'Paste or drop', () => import('../views/paste/paste')),
    styles: '',
    changes: true,
  },
  {
    name: 'take-away',
    place: 'folds',
    create: panel('take-away', 'Take away', () => import('../views/take-away/take-away')),
    styles: '',
  },
  {
    name: 'embed',
    place: 'panel',
    create: panel('embed', 'Copy embed', () => import('../views/embed/embed')),
    styles: '',
  },
  { name: 'scene', place: 'stage', create: createScene, styles: sceneStyles, prepare: prepareScene },
]
