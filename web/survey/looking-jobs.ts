/** Jobs that only look at the open mesh; the worker in the package's file knows these and no others. */
import type { Wanted } from '../core/batch/lists'
import { seldom } from '../core/workers'
import { cellClassifier } from '../input/classify-cells'
import type { PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import { coreOf, meshOf, type ReadingEngine, refusalOf, toldSeldom } from '../input/serve-reading'
import { checkMesh } from '../mesh/check'
import { MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { Survey } from './survey'
import type { Opening, SurveyJobs } from './survey-jobs'

type AskedOfOne = Pick<SurveyJobs, 'rows' | 'arrange' | 'nextInvalid' | 'placeOf' | 'detail' | 'join' | 'faces'>

export type LookingJobs = AskedOfOne & Pick<SurveyJobs, 'open'>

/** Lists that the rows show. */
const LISTS: Wanted = { minima: true, volumes: true, acceptedBy: true }

/** All jobs of a worker in whose mesh nothing is selected, changed or written. */
export function jobsOfLooking(engine: ReadingEngine): LookingJobs {
  let open: Survey | null = null

  async function opening(input: PastedInput, tell: (progress: ReadingProgress) => void): Promise<Opening> {
    const mesh = await meshOf(input, engine, tell)
    const core = await coreOf(engine)
    const onProgress = (done: number, total: number) => tell({ step: 'deciding', fraction: done / total })
    const classify = cellClassifier(core, engine.batchModule, onProgress)
    const options = { worst: Infinity, minRelative: null, skipsDegenerate: false, lists: LISTS }
    const check = await checkMesh(mesh, { classify, core }, options)
    const survey = new Survey(check, { core, meeting: null })
    const overview = survey.overview(nameOf(input))
    if (check.hexahedra === 0) throw noHexahedra(check, overview.sentences)
    open = survey
    return { opened: overview }
  }

  return {
    open: (input, tell) => opening(input, toldSeldom(tell)).catch(refusalOf),
    ...lookingJobs(() => {
      if (!open) throw new Error('No mesh is open.')
      return open
    }),
  }
}

/** `survey` throws while no mesh is open. */
export function lookingJobs(survey: () => Survey): AskedOfOne {
  return {
    rows: ({ from, to }) => survey().rows(from, to),
    arrange(order) {
      survey().arrange(order)
      return null
    },
    nextInvalid: ({ rank, step }) => survey().nextInvalid(rank, step),
    placeOf: cell => survey().placeOf(cell),
    detail: cell => survey().detail(cell),
    join: (_, tell) => ({ boundaryFaces: survey().join(seldom(tell)) }),
    faces: shown => survey().faces(shown),
  }
}

export function noHexahedra({ mesh }: MeshCheck, sentences: readonly string[]): MeshRefusal {
  return new MeshRefusal([`Read as ${mesh.format}: no hexahedra of eight nodes.`, ...sentences].join(' '))
}

export function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}
