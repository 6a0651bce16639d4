/** Jobs that only look at the open mesh; the worker in the package's file knows these and no others. */
import { cellClassifier } from '../input/classify-cells'
import { inputName, type PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import { coreOf, meshOf, type ReadingEngine, refusalOf, toldSeldom } from '../input/serve-reading'
import { checkMesh } from '../mesh/check'
import { MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { OpenedSurvey } from './opened-survey'
import { Survey } from './survey'
import type { Opening, Served, SurveyJobs } from './survey-jobs'

type AskedOfOne = Pick<
  SurveyJobs,
  'rows' | 'accept' | 'arrange' | 'nextInvalid' | 'placeOf' | 'detail' | 'join' | 'faces'
>

export type LookingJobs = Served<AskedOfOne & Pick<SurveyJobs, 'open'>>

/** Milliseconds of a step of what takes long: other questions wait so long. */
export const STEP = 12

/** All at once: what opens a mesh in two steps is larger than the gain. */
const OPTIONS = {
  worst: Infinity,
  minRelative: null,
  skipsDegenerate: false,
  lists: { minima: true, volumes: true, acceptedInvalid: true },
} as const

/** All jobs of a worker in whose mesh nothing is selected, changed or written. */
export function jobsOfLooking(engine: ReadingEngine): LookingJobs {
  let open: OpenedSurvey | null = null

  async function opening(input: PastedInput, tell: (progress: ReadingProgress) => void): Promise<Opening> {
    const mesh = await meshOf(input, engine, tell)
    const core = await coreOf(engine)
    const onProgress = (done: number, total: number) => tell({ step: 'deciding', fraction: done / total })
    const classify = cellClassifier(core, engine.batchModule, onProgress)
    const check = await checkMesh(mesh, { classify, core }, OPTIONS)
    const survey = new Survey(check, { core, meeting: null })
    const overview = survey.overview(inputName(input))
    if (check.hexahedra === 0) throw noHexahedra(check, overview.sentences)
    open = new OpenedSurvey(survey, null, classify)
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

/** `opened` throws while no mesh is open. */
export function lookingJobs(opened: () => OpenedSurvey): Served<AskedOfOne> {
  const whole = () => opened().whole()
  return {
    rows: async ({ from, to }) => (await opened().withRows(to)).rows(from, to),
    accept: cells => opened().accept(cells),
    async arrange(order) {
      const survey = await (order.column === 'accepted-by' ? opened().accepting() : whole())
      survey.arrange(order)
      return null
    },
    nextInvalid: async ({ rank, step }) => (await whole()).nextInvalid(rank, step),
    placeOf: async cell => (await whole()).placeOf(cell),
    detail: async cell => (await opened().withCell(cell)).detail(cell),
    join: async () => (await whole()).join(STEP),
    faces: async shown => (await whole()).faces(shown),
  }
}

export function noHexahedra({ mesh }: MeshCheck, sentences: readonly string[]): MeshRefusal {
  return new MeshRefusal([`Read as ${mesh.format}: no hexahedra of eight nodes.`, ...sentences].join(' '))
}
