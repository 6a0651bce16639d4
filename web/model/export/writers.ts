/** What an element's vertices can be taken away as. */
import { c } from './c'
import type { Writer } from './element'
import { obj } from './obj'
import { python } from './python'
import { vtk } from './vtk'

export const writers: readonly Writer[] = [python, c, vtk, obj]
