/**
 * The report: everything the core knows about one hexahedron, immutable, the single source of every number shown.
 *
 * Units: jacdet is that of the map from [0,1]^3 (on [-1,1]^3 it is an eighth). Every jacdet in a report is its number
 * times 2^exponent; `exponent` is 0 unless some value of this element lies outside the doubles' normal range.
 */
import type { Vec3, Vertices } from '../model/hexahedron'
import type { Result as AnyResult } from '../model/result'

export type CandidateKind = 'vertex' | 'edge' | 'face'

/** A boundary point that may be the minimizer (method: docs/algorithm.md). */
export interface Candidate {
  readonly kind: CandidateKind
  /** Vertex 0..7, edge 0..11 or face 0..5, by `kind`. */
  readonly id: number
  /** (xi, eta, zeta) in [0,1]^3. */
  readonly point: Vec3
  /** The point's image in physical space, in the units of the vertices. */
  readonly position: Vec3
  /** jacdet there, times 2^exponent. */
  readonly value: number
}

/** Valid; jacdet < 0 everywhere; jacdet = 0 everywhere; or invalid otherwise. */
export type ElementClass = 'valid' | 'invalid' | 'inverted' | 'collapsed'

/** The shape that coincident vertices make of an element, in any of the cube's 48 symmetries. */
export type Shape = 'wedge' | 'pyramid' | 'tetrahedron'

/** The fate of a root t of a face's quartic P: kept as a candidate, or dropped and why. */
export type RootFate = 'kept' | 'a-not-positive' | 's-outside'

export interface FaceRoot {
  readonly t: number
  /** a(t), times 2^exponent: half the curvature of the parabola in s. */
  readonly a: number
  /** s* = -b/(2a); null where a(t) <= 0. */
  readonly s: number | null
  readonly fate: RootFate
}

export interface FaceReport {
  /** 0..5: -xi, +xi, -eta, +eta, -zeta, +zeta. */
  readonly id: number
  /** The nine Bernstein coefficients of jacdet on the face, `bernstein[3 * i + j]` with i in s, j in t. */
  readonly bernstein: readonly number[]
  /** L_R, the least of the nine. */
  readonly lowerBound: number
  /** M, the least jacdet found before this face was looked at. */
  readonly runningMinimum: number
  /** L_R >= M: a minimum query skips the face. */
  readonly skippedByMinimumRule: boolean
  /** L_R > 0: a validity query skips the face. */
  readonly skippedByValidityRule: boolean
  /** Bernstein coefficients of P, degree 4, on [0,1], times 2^quarticExponent. */
  readonly quartic: readonly number[]
  readonly quarticExponent: number
  /** P is zero within rounding: by the lemma the edges suffice. */
  readonly quarticIsZero: boolean
  /** The roots of P in (0,1), ascending, at most four. */
  readonly roots: readonly FaceRoot[]
}

/** The least jacdet over the closed element, certain to be in [lower, upper]; times 2^exponent. */
export interface VolumeMinimum {
  readonly lower: number
  readonly upper: number
  /** jacdet is at most `upper` here, or at the point that these doubles are rounded from. */
  readonly point: Vec3
  readonly position: Vec3
}

/** Checks of other programs: web/panels/checks/check-words.ts says whose and how. */
export type CheckId =
  | 'corners'
  | 'corners-and-centre'
  | 'gauss-2'
  | 'gauss-3'
  | 'edges'
  | 'bernstein'
  | 'subdivision'
  | 'tangents'

export interface Check {
  readonly id: CheckId
  /** A jacdet, times 2^exponent; Verdict's scaled Jacobian: from -1 to 1, 1e30 if a length is 0. */
  readonly value: number
  /** value > 0: it takes the element for valid; for `tangents`, that it certifies it, else it says nothing. */
  readonly passes: boolean
}

export interface Report {
  readonly vertices: Vertices
  /** jacdet > 0 on the whole element, which by Knupp's conjecture (a theorem) its boundary decides. */
  readonly valid: boolean
  /** Doubles with their error bounds, or, where those leave it open, integers. Either way the verdict is certain. */
  readonly decidedBy: 'filter' | 'exact'
  readonly exponent: number
  /** Its sign is the exact one: 0 means exactly zero. */
  readonly boundaryMinimum: number
  /** |boundaryMinimum - the exact one| is at most this; times 2^exponent. */
  readonly boundaryMinimumError: number
  readonly minimizer: Candidate
  /** The boundary minimum with its error if the element is valid; it may be lower if not. */
  readonly volumeMinimum: VolumeMinimum
  readonly checks: readonly Check[]
  readonly boundaryMaximum: number
  readonly maximizer: Candidate
  /** Least jacdet at the eight vertices, and on the twelve edges. */
  readonly cornerMinimum: number
  readonly edgeMinimum: number
  /** The least of jacdet over the lengths of its three columns at the vertices and the centre, from -1 to 1; 0 where a column is 0. */
  readonly scaledJacobian: number
  /** The 27 Bernstein coefficients of jacdet on [0,1]^3, `bernstein[9 * i + 3 * j + k]`, i in xi, j in eta, k in zeta. */
  readonly bernstein: readonly number[]
  readonly class: ElementClass
  /** The groups of vertices at the same position, each ascending, in the order of their first: [[4, 5], [6, 7]]. */
  readonly coincident: readonly (readonly number[])[]
  /** Null where the coincidences make none of them. */
  readonly shape: Shape | null
  /** The mean of jacdet, times 2^volumeExponent, rounded to the nearest double. */
  readonly volume: number
  readonly volumeExponent: number
  /** boundaryMinimum over |volume|, a number without a dimension; null where the volume is 0. */
  readonly relativeMinimum: number | null
  /** All of them: vertices, then edges, then faces. */
  readonly candidates: readonly Candidate[]
  readonly faces: readonly FaceReport[]
}

/** DF at one reference point. */
export interface JacobianReport {
  readonly point: Vec3
  readonly position: Vec3
  /** The columns dF/dxi, dF/deta, dF/dzeta; component `a` of each is its number times 2^axisExponents[a]. */
  readonly columns: readonly [Vec3, Vec3, Vec3]
  readonly axisExponents: Vec3
  /** det DF, times 2^exponent, correctly rounded from its exact value: 0 means exactly zero. */
  readonly jacdet: number
  readonly exponent: number
}

export type CoreErrorCode = 'wrong-count' | 'not-finite' | 'outside-cube' | 'incomplete'

/** A typed refusal at the boundary; `message` is a clear sentence for people. */
export interface CoreError {
  readonly code: CoreErrorCode
  readonly message: string
  /** The one of many cells that is incomplete. */
  readonly cell?: number
}

export type Result<T> = AnyResult<T, CoreError>

/** The C core as TypeScript sees it. */
export interface Core {
  analyze(vertices: Vertices): Result<Report>
  /** The certain verdict, without the report. */
  isValid(vertices: Vertices): Result<boolean>
  /** Boundary minimum by Algorithm 1 with (`roots-b`) or without (`roots`) the Bernstein face bounds. */
  boundaryMinimum(vertices: Vertices, variant: 'roots' | 'roots-b'): Result<{ minimizer: Candidate; exponent: number }>
  /** `point` must lie in [0,1]^3. */
  jacobian(vertices: Vertices, point: Vec3): Result<JacobianReport>
}
