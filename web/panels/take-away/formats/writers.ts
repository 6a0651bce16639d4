/** The formats in which an element's vertices can be taken away. */

import type { Writer } from '../../../model/written-element'
import { c } from './c'
import { obj } from './obj'
import { python } from './python'
import { vtk } from './vtk'

export const writers: readonly Writer[] = [python, c, vtk, obj]
