/** The worker in which a mesh is open: it reads, decides, and answers what the page asks. It is ended with the mesh. */
import type { Core } from '../core/report'
import { serve, type WorkerPort } from '../core/workers'
import { inputName, type PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import {
  coreOf,
  filesOf,
  LOADING_BEGINS,
  meshOf,
  type ReadingEngine,
  refusalOf,
  toldSeldom,
} from '../input/serve-reading'
import { checkMesh } from '../mesh/check'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import type { TogetherOptions } from '../mesh/read-mesh'
import type { StepAnswer } from '../mesh/step-answers'
import { isCollection, type StepFiles, stepFilesOf, stepsWithin } from '../mesh/step-files'
import { cutFaces } from './cut'
import { lookingJobs, noHexahedra, STEP } from './looking-jobs'
import { meeting } from './meeting'
import { mended } from './mend'
import { Movement } from './movement'
import { inOwnFormat, type Moving, movingJobs, roundedNote } from './moving-jobs'
import { OpenedSurvey } from './opened-survey'
import { FIRST_LISTS, openingCheck } from './opening-check'
import { PRACTICE, practiceFile } from './practice'
import { type SharedClassifier, sharedClassifier } from './shared-classifier'
import { type StepMesh, StepSeries } from './step-series'
import { Survey } from './survey'
import {
  ACCEPTED_IN,
  type FixId,
  type FormId,
  type Opening,
  type Overview,
  type Served,
  type StepOpening,
  type StepWanted,
  type SurveyJobs,
  type Written,
} from './survey-jobs'
import { wholeOrderOf } from './whole-order'
import { Writing } from './writing'

/** Bytes of a file that has many cells. */
const LARGE = 4 * 1024 * 1024

interface Tools {
  readonly core: Core
  readonly classifier: SharedClassifier
}

type Open = Omit<Moving, 'files'>

/** The steps that the open mesh is one of. */
interface OpenSteps {
  readonly series: StepSeries
  readonly shown: number
  readonly isOther: boolean
}

type Tell = (progress: ReadingProgress) => void

/** With what starts a worker for batches. */
export interface SurveyEngine extends ReadingEngine {
  readonly helper: () => WorkerPort
}

async function decided(name: string, mesh: Mesh, { core, classifier }: Tools, before: Survey | null) {
  const { classify } = classifier
  const { check, finish } = await openingCheck(mesh, { classify, core })
  const survey = new Survey(check, { core, meeting }, before)
  const overview = survey.overview(name, await wholeOrderOf(check, { classify, core }))
  if (check.hexahedra === 0) throw noHexahedra(check, overview.sentences)
  return { survey, finish, overview }
}

export function serveSurvey(engine: SurveyEngine): void {
  let open: Open | null = null
  let steps: OpenSteps | null = null
  let given: PastedInput = { files: [] }
  let writing: Writing | null = null

  function opened(): Open {
    if (!open) throw new Error('No mesh is open.')
    return open
  }

  const moving = (): Moving => ({ ...opened(), files: steps ? [] : filesOf(given) })

  /** The core and the workers that decide, started once. */
  let started: Promise<Tools> | null = null
  let onDecided: (fraction: number) => void = () => {}
  const tools = (): Promise<Tools> => {
    started ??= coreOf(engine).then(core => {
      const onProgress = (done: number, total: number) => onDecided(done / total)
      return { core, classifier: sharedClassifier({ ...engine, core, onProgress }) }
    })
    return started
  }

  const whole = () => opened().survey.whole()

  /** With the checks that accept the cells of which the file says so. */
  async function checkFor(form: FormId): Promise<MeshCheck> {
    const { survey } = opened()
    const of = ACCEPTED_IN[form]
    if (of === 'invalid') return survey.acceptingInvalid()
    return (await (of === 'all' ? survey.accepting() : survey.whole())).check
  }

  function written(): Written {
    return writing?.run(STEP) ?? { refused: 'The mesh is another one by now.' }
  }

  function openSteps(): OpenSteps {
    if (!steps) throw new Error('The mesh that is open has no steps.')
    return steps
  }

  /** What is open stays if the mesh is refused. */
  async function surveyed(name: string, mesh: Mesh, tell: Tell, before: Survey | null = null): Promise<Overview> {
    const own = await tools()
    const { classify } = own.classifier
    onDecided = fraction => tell({ step: 'deciding', fraction })
    const { survey, finish, overview } = await decided(name, mesh, own, before)
    open = {
      name,
      survey: new OpenedSurvey(survey, finish, classify),
      movement: new Movement(mesh),
      classify,
      core: own.core,
    }
    writing = null
    return overview
  }

  /** Reads, a second time with the reader of HDF5 files where that is needed. */
  async function reading<T>(tell: Tell, work: (options: TogetherOptions) => T | Promise<T>): Promise<T> {
    const onProgress = (fraction: number) => tell({ step: 'reading', fraction })
    const options = { onProgress, throwIfCancelled: () => {}, core: await engine.readingCore() }
    return engine.hdf5.reading(
      hdf5 => work({ ...options, hdf5 }),
      () => tell(LOADING_BEGINS),
    )
  }

  async function opening(input: PastedInput, tell: Tell): Promise<Opening> {
    given = input
    if ('files' in input && input.files.some(({ size }) => size > LARGE))
      void tools().then(({ classifier }) => classifier.prepare())
    const found = 'files' in input ? await reading(tell, options => stepFilesOf(filesOf(input), options)) : null
    if (found) return { opened: await openedStep(found, tell) }
    const mesh = await read(input, tell)
    const within = stepsWithin(mesh, filesOf(input))
    return { opened: await (within ? openedStep(within, tell) : surveyed(inputName(input), mesh, tell)) }
  }

  /** Its cells are decided while it is read. */
  async function read(input: PastedInput, tell: Tell): Promise<Mesh> {
    const { classifier } = await tools()
    return meshOf(input, engine, tell, {
      onCells: (points, cells, count) => classifier.know(points, cells, count, FIRST_LISTS),
      readers: classifier.readers(),
    })
  }

  function readOf(series: StepSeries, step: number, tell: Tell): Promise<StepMesh> {
    return reading(tell, options => series.read(step, options))
  }

  /** The first step that can be opened. */
  async function openedStep(found: StepFiles, tell: Tell): Promise<Overview> {
    const series = new StepSeries(found)
    let refusal: unknown = null
    for (let step = 0; step < series.count; ++step)
      try {
        const { mesh, isOther } =
          step === 0 && found.first ? series.taken(found.first) : await readOf(series, step, tell)
        const overview = await surveyed(series.nameOf(step), mesh, tell)
        steps = { series, shown: step, isOther }
        return overview
      } catch (reason) {
        if (!(reason instanceof MeshRefusal)) throw reason
        refusal ??= reason
      }
    throw refusal
  }

  /** The worst cell is known from the beginning. */
  function shownAnswer(): StepAnswer {
    const { series, shown, isOther } = openSteps()
    return series.answerOf(shown, opened().survey.survey.check, isOther)
  }

  async function readStep(step: number, tell: Tell): Promise<StepAnswer> {
    const { series, shown } = openSteps()
    if (step === shown) return shownAnswer()
    const { mesh, isOther } = await readOf(series, step, tell)
    const check = await checkMesh(mesh, opened(), { worst: 1, minRelative: null, skipsDegenerate: false })
    if (check.hexahedra === 0) throw noHexahedra(check, check.notes)
    return series.answerOf(step, check, isOther)
  }

  async function showStep({ step, chosen }: StepWanted, tell: Tell): Promise<StepOpening> {
    const { series } = openSteps()
    const before = await whole()
    const { mesh, isOther } = await readOf(series, step, tell)
    const overview = await surveyed(series.nameOf(step), mesh, tell, before)
    steps = { series, shown: step, isOther }
    return {
      opened: overview,
      answer: shownAnswer(),
      chosen: chosen === null ? null : (await whole()).sameCell(before, chosen),
    }
  }

  async function together(tell: Tell): Promise<Opening> {
    const parts = 'files' in given ? { files: given.files.filter(file => !isCollection(file)) } : given
    const overview = await surveyed(inputName(parts), await meshOf(parts, engine, tell), tell)
    steps = null
    return { opened: overview }
  }

  serve<null, Served<SurveyJobs>>('hexlens-survey', () => ({
    async prepare() {
      const [own] = await Promise.all([tools(), engine.readingCore()])
      // One by one it would last, and whoever opens a mesh would wait for it.
      return (await own.classifier.prepare()) ? PRACTICE : []
    },
    async practise({ noise, isWhole }) {
      const file = practiceFile(noise)
      const { finish } = await decided(file.name, await read({ files: [file] }, () => {}), await tools(), null)
      if (isWhole) await finish?.()
      return null
    },
    open: (input, tell) => opening(input, toldSeldom(tell)).catch(refusalOf),
    ...lookingJobs(() => opened().survey),
    select: async selection => (await whole()).select(selection),
    selectOn: async () => (await whole()).selectOn(STEP),
    find: async ({ id, after }) => (await whole()).find(id, after),
    histogram: async () => (await whole()).histogram(),
    cut: async cells => cutFaces((await whole()).faced, cells),
    async mend(fix: FixId) {
      const { check } = await whole()
      const mesh = mended(check, fix)
      const { movement } = opened()
      const overview = await surveyed(opened().name, mesh, () => {})
      open = { ...opened(), movement: new Movement(mesh, movement) }
      steps?.series.correct(check.mesh, mesh)
      return { opened: overview }
    },
    async write(form) {
      const { name, core } = opened()
      const check = await checkFor(form)
      const own = form === 'own' ? { chunks: inOwnFormat(moving()), said: await roundedNote(moving()) } : null
      writing = new Writing(form, { name, check, core, own })
      return written()
    },
    writeOn: written,
    ...movingJobs(moving, survey => {
      open = { ...opened(), survey }
      writing = null
    }),
    steps: () => steps?.series.list(steps.shown, shownAnswer()) ?? null,
    readStep: (step, tell) =>
      readStep(step, toldSeldom(tell)).catch(reason => openSteps().series.refusedStep(step, refusalOf(reason).refused)),
    showStep: (wanted, tell) => showStep(wanted, toldSeldom(tell)).catch(refusalOf),
    together: (_, tell) => together(toldSeldom(tell)).catch(refusalOf),
  }))
}
