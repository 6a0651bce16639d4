/** All facts, in the order of web/mesh/format-names.ts; then those of texts. */
import { formatNames } from '../../web/mesh/format-names'
import type { FormatFacts } from './fact'
import { mesherFacts } from './facts-meshers'
import { nekFacts } from './facts-nek'
import { solverFacts } from './facts-solvers'
import { textFacts } from './facts-texts'
import { vtkFacts } from './facts-vtk'

const all: readonly FormatFacts[] = [...vtkFacts, ...mesherFacts, ...solverFacts, ...nekFacts]

export const FACTS: readonly FormatFacts[] = [
  ...formatNames.flatMap(name => all.filter(({ format }) => format === name)),
  ...textFacts,
]
