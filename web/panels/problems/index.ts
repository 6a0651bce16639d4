import type { Panel } from '../panel'
import { createProblems, problemsStyles } from './problems'

export const problems: Panel = {
  name: 'problems',
  region: 'head',
  create: createProblems,
  styles: problemsStyles,
  always: true,
}
