/** Answers of batches: lists with an entry for each cell, in one block of memory. */
import type { CoreErrorCode } from '../report'

/** Lists beside the verdicts. A list that is not asked for costs nothing. */
export interface Wanted {
  readonly minima?: boolean
  /** False leaves the minimizers out of the minima: half of the memory. */
  readonly minimizers?: boolean
  readonly relativeMinima?: boolean
  readonly volumes?: boolean
  readonly classes?: boolean
  readonly acceptedBy?: boolean
  readonly exact?: boolean
  readonly statuses?: boolean
  readonly coincident?: boolean
  /** Only together with minima. */
  readonly acceptedInvalid?: boolean
  /** No list: the box of the cells (Counts). */
  readonly box?: boolean
  /** No list: candidates for so many of the worst cells. Only together with minima. */
  readonly worst?: number
}

/** Jacdets on [0,1]^3, times 2^exponent, which is 0 wherever the doubles have room for the values. */
export interface Minima {
  readonly values: Float64Array
  /** The points that attain them: xi, eta, zeta. Empty if they were left out. */
  readonly minimizers: Float64Array
  /** The least jacdet at the eight vertices. */
  readonly cornerMinima: Float64Array
  readonly exponents: Int16Array
}

/** The mean of jacdet, rounded to the nearest double, times 2^exponent. */
export interface Volumes {
  readonly values: Float64Array
  readonly exponents: Int16Array
}

interface AllLists {
  readonly minima: Minima
  /** The boundary minimum over |volume|; NaN where the volume is 0. */
  readonly relativeMinima: Float64Array
  readonly volumes: Volumes
  /** Indices into CLASSES. */
  readonly classes: Uint8Array
  /** Bit 1 << c for each check that accepts the cell, c its index in CHECKS. */
  readonly acceptedBy: Uint16Array
  /** 1 for a cell that integers decided, as doubles left it open. */
  readonly exact: Uint8Array
  /** Indices into STATUSES. */
  readonly statuses: Uint8Array
  /** 1 for a cell that has two vertices or more at one position. */
  readonly coincident: Uint8Array
  /** The checks among the corners and VTK's scaled Jacobian that accept an invalid cell, as in `acceptedBy`; 0 for a valid one. */
  readonly acceptedInvalid: Uint8Array
}

/** Why a cell is unanswered, by its status; undefined if it is answered. */
export type CellStatus = Extract<CoreErrorCode, 'not-finite'> | 'no-such-point'
export const STATUSES: readonly (CellStatus | undefined)[] = [
  undefined,
  'not-finite',
  undefined,
  undefined,
  'no-such-point',
]

type Given<Asked, List> = Asked extends true ? List : null

/** One entry a cell; lists that were not asked for are null. Of a cell that is unanswered all numbers are NaN, all integers 0. */
export type Answers<W extends Wanted = Wanted> = {
  /** 1 for a valid cell, 0 for an invalid one: exact, every one. 0 for one that is unanswered, too. */
  readonly valid: Uint8Array
} & { readonly [List in keyof AllLists]: Given<W[List], AllLists[List]> }

interface Description {
  readonly askedBy: keyof Wanted | 'always'
  readonly type: typeof Float64Array | typeof Int16Array | typeof Uint16Array | typeof Uint8Array
  /** Entries a cell. */
  readonly each: number
}

/** The lists of hl_batch and of batch_hints, in their order. */
const LISTS: readonly Description[] = [
  { askedBy: 'always', type: Uint8Array, each: 1 }, // verdicts
  { askedBy: 'statuses', type: Uint8Array, each: 1 },
  { askedBy: 'exact', type: Uint8Array, each: 1 },
  { askedBy: 'classes', type: Uint8Array, each: 1 },
  { askedBy: 'acceptedBy', type: Uint16Array, each: 1 },
  { askedBy: 'minima', type: Float64Array, each: 1 },
  { askedBy: 'minimizers', type: Float64Array, each: 3 },
  { askedBy: 'minima', type: Float64Array, each: 1 }, // corner minima
  { askedBy: 'minima', type: Int16Array, each: 1 }, // exponents
  { askedBy: 'relativeMinima', type: Float64Array, each: 1 },
  { askedBy: 'volumes', type: Float64Array, each: 1 },
  { askedBy: 'volumes', type: Int16Array, each: 1 }, // exponents
  { askedBy: 'coincident', type: Uint8Array, each: 1 },
  { askedBy: 'acceptedInvalid', type: Uint8Array, each: 1 },
]

type List = Float64Array<ArrayBuffer> | Int16Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint8Array<ArrayBuffer>

/** One entry for each of LISTS, null if it was not asked for. */
export type Lists = readonly (List | null)[]

/** The flags alone, as a message takes them. */
export function wantedOf(options: Wanted): Wanted {
  const isAsked = isAskedBy(options)
  const flags = Object.fromEntries(LISTS.map(list => [list.askedBy, isAsked(list)]))
  return { ...flags, box: options.box === true, worst: options.worst ?? 0 }
}

function isAskedBy(wanted: Wanted): (list: Description) => boolean {
  const asked = { ...wanted, minimizers: wanted.minima === true && wanted.minimizers !== false, always: true }
  return ({ askedBy }) => asked[askedBy] === true
}

export function bytesPerCell(wanted: Wanted): number {
  return LISTS.filter(isAskedBy(wanted)).reduce((sum, { type, each }) => sum + each * type.BYTES_PER_ELEMENT, 0)
}

/** Bytes of an entry: those that are longer come first, so that all are aligned. */
const SIZES = [8, 4, 2, 1]

/** The lists for so many cells as they lie in a block, from a byte on. */
export function listsIn(block: ArrayBuffer, count: number, wanted: Wanted, from = 0): Lists {
  const isAsked = isAskedBy(wanted)
  let at = from
  const lists: (List | null)[] = LISTS.map(() => null)
  for (const size of SIZES)
    for (const [i, list] of LISTS.entries()) {
      if (list.type.BYTES_PER_ELEMENT !== size || !isAsked(list)) continue
      lists[i] = new list.type(block, at, list.each * count)
      at += lists[i].byteLength
    }
  return lists
}

export function emptyLists(count: number, wanted: Wanted): Lists {
  return listsIn(new ArrayBuffer(count * bytesPerCell(wanted)), count, wanted)
}

export function emptyAnswers<W extends Wanted>(count: number, wanted: W): Answers<W> {
  return answersOf(emptyLists(count, wanted)) as Answers<W>
}

/** Puts lists into longer ones, as those of the cells from `first` on. */
export function putLists(lists: Lists, into: Lists, first: number): void {
  for (const [i, { each }] of LISTS.entries()) {
    const list = lists[i]
    if (list) into[i]?.set(list, each * first)
  }
}

/** The entries of so many cells from the cell `first` on, in the same memory. */
export function partOf(lists: Lists, first: number, count: number): Lists {
  return LISTS.map(({ each }, i) => lists[i]?.subarray(each * first, each * (first + count)) ?? null)
}

/** Byte addresses of the core's entries from the cell `first` on; 0 for a list that is not there. */
export function addressesOf(lists: Lists, first: number): number[] {
  return LISTS.map(({ type, each }, i) => {
    const list = lists[i]
    return list ? list.byteOffset + first * each * type.BYTES_PER_ELEMENT : 0
  })
}

/** The lists by name. The first holds verdicts, whose HL_VALID is 1, or already 1 and 0. */
export function answersOf(lists: Lists): Answers {
  const [valid, statuses, exact, classes, acceptedBy, values, minimizers, cornerMinima, exponents, ...more] = lists
  const [relativeMinima, volumes, volumeExponents, coincident, acceptedInvalid] = more
  return {
    valid,
    minima: values && { values, minimizers: minimizers ?? new Float64Array(0), cornerMinima, exponents },
    relativeMinima,
    volumes: volumes && { values: volumes, exponents: volumeExponents },
    classes,
    acceptedBy,
    exact,
    statuses,
    coincident,
    acceptedInvalid,
  } as Answers
}
