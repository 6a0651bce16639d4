/** The worker in which a mesh is open: it reads, decides, and answers what the page asks. It is ended with the mesh. */
import type { Wanted } from '../core/batch/lists'
import type { Core } from '../core/report'
import { seldom, serve } from '../core/workers'
import { cellClassifier } from '../input/classify-cells'
import type { PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import { coreOf, meshOf, type ReadingEngine, refusalOf } from '../input/serve-reading'
import { type ClassifyCells, checkMesh } from '../mesh/check'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import { mended } from './mend'
import { Survey } from './survey'
import type { FixId, Opening, SurveyJobs } from './survey-jobs'
import { wholeOrderOf } from './whole-order'

/** Lists that the page shows beside those that the counts need. */
const LISTS: Wanted = { minima: true, volumes: true, acceptedBy: true }

/** Milliseconds of a selection's step: other questions wait so long. */
const STEP = 12

export function serveSurvey(engine: ReadingEngine): void {
  let open: {
    readonly name: string
    readonly survey: Survey
    readonly classify: ClassifyCells
    readonly core: Core
  } | null = null

  function survey(): Survey {
    if (!open) throw new Error('No mesh is open.')
    return open.survey
  }

  async function surveyed(name: string, mesh: Mesh, tell: (progress: ReadingProgress) => void): Promise<Opening> {
    const core = open?.core ?? (await coreOf(engine))
    const onProgress = (done: number, total: number) => tell({ step: 'deciding', fraction: done / total })
    const classify = open?.classify ?? cellClassifier(core, engine.batchModule, onProgress)
    const options = { worst: Infinity, minRelative: null, skipsDegenerate: false, lists: LISTS }
    const check = await checkMesh(mesh, { classify, core }, options)
    open = { name, survey: new Survey(check, core), classify, core }
    const overview = open.survey.overview(name, await wholeOrderOf(check, { classify, core }))
    if (check.hexahedra > 0) return { opened: overview }
    throw new MeshRefusal([`Read as ${mesh.format}: no hexahedra of eight nodes.`, ...overview.sentences].join(' '))
  }

  async function opening(input: PastedInput, tell: (progress: ReadingProgress) => void): Promise<Opening> {
    return surveyed(nameOf(input), await meshOf(input, engine, seldom(tell)), seldom(tell))
  }

  serve<null, SurveyJobs>('hexlens-survey', () => ({
    open: (input, tell) => opening(input, tell).catch(refusalOf),
    rows: ({ from, to }) => survey().rows(from, to),
    arrange(order) {
      survey().arrange(order)
      return null
    },
    select: selection => survey().select(selection),
    selectOn: () => survey().selectOn(STEP),
    find: ({ id, after }) => survey().find(id, after),
    nextInvalid: ({ rank, step }) => survey().nextInvalid(rank, step),
    placeOf: cell => survey().placeOf(cell),
    histogram: () => survey().histogram(),
    detail: cell => survey().detail(cell),
    join: (_, tell) => ({ boundaryFaces: survey().join(seldom(tell)) }),
    faces: shown => survey().faces(shown),
    async mend(fix: FixId) {
      const { check } = survey()
      return surveyed(open?.name ?? '', mended(check, fix), () => {})
    },
  }))
}

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}
