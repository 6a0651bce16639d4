/** Loads the C core and is the only place that sees its memory. The contracts are those of wasm/include/hexlens.h. */
import { COORDINATE_COUNT, type Vertices } from '../model/hexahedron'
import { exactJacdetAt } from './exact/exact-jacdet'
import type { Core, CoreError, Report, Result } from './report'
import { Unpacker, unpackJacobian, unpackMinimum, unpackReport, unpackVerdict } from './unpack'

/** Exports of hexlens.wasm, of the modules for batches, and of hexlens-twin.js, made by wasm2js. */
export interface CoreExports {
  readonly memory: { readonly buffer: ArrayBuffer }
  readonly _initialize?: () => void
  input_address(): number
  output_address(): number
  output_length(): number
  analyze(): number
  input_length(): number
  boundary_minimum(variant: number): number
  decide(): number
  jacobian_at(): number
}

/** Statuses of hexlens.h. */
const HL_OK = 0
const HL_NOT_FINITE = 1
const HL_OUTSIDE_CUBE = 2
const HL_ROOTS = 0
const HL_ROOTS_B = 1

function refusal(code: CoreError['code'], message: string): { ok: false; error: CoreError } {
  return { ok: false, error: { code, message } }
}

function firstNotFinite(vertices: Vertices): string {
  const at = vertices.findIndex(value => !Number.isFinite(value))
  return at < 0 ? 'A coordinate' : `Vertex ${Math.floor(at / 3)} ${'xyz'[at % 3]}`
}

/**
 * Compiles and starts the core from the bytes of hexlens.wasm. Rejects with the engine's own error when WebAssembly is
 * missing, forbidden, or the bytes are not the core's.
 */
export async function loadCore(bytes: BufferSource): Promise<Core> {
  const { instance } = await WebAssembly.instantiate(bytes, {})
  return coreOf(instance.exports as unknown as CoreExports)
}

/** Starts the core in an instance that has just been made. The functions of a Core never throw for any numbers given. */
export function coreOf(wasm: CoreExports): Core {
  wasm._initialize?.()
  let input = new Float64Array(0)
  let output = input

  /** Memory that has grown, as it does for batches, is another buffer. */
  function renewViews(): void {
    const { buffer } = wasm.memory
    if (input.buffer === buffer) return
    input = new Float64Array(buffer, wasm.input_address(), wasm.input_length())
    output = new Float64Array(buffer, wasm.output_address(), wasm.output_length())
  }

  function answer<T>(vertices: Vertices, more: readonly number[], run: () => number, read: () => T): Result<T> {
    if (vertices.length !== COORDINATE_COUNT)
      return refusal('wrong-count', `A hexahedron has ${COORDINATE_COUNT} coordinates, not ${vertices.length}.`)
    renewViews()
    input.set(vertices)
    input.set(more, COORDINATE_COUNT)
    const status = run()
    if (status === HL_OK) return { ok: true, value: read() }
    if (status === HL_OUTSIDE_CUBE) return refusal('outside-cube', 'The reference point is not in [0,1]³.')
    if (status === HL_NOT_FINITE && more.some(value => !Number.isFinite(value)))
      return refusal('not-finite', 'The reference point is not a finite point.')
    if (status === HL_NOT_FINITE) return refusal('not-finite', `${firstNotFinite(vertices)} is not a finite number.`)
    throw new Error(`The core answered with an unknown status, ${status}.`)
  }

  function analyze(vertices: Vertices): Result<Report> {
    return answer(vertices, [], wasm.analyze, () =>
      unpackReport(new Unpacker(output), Object.freeze(Array.from(vertices))),
    )
  }

  function isValid(vertices: Vertices): Result<boolean> {
    return answer(vertices, [], wasm.decide, () => unpackVerdict(new Unpacker(output)))
  }

  return {
    analyze,
    isValid,
    boundaryMinimum: (vertices, variant) =>
      answer(
        vertices,
        [],
        () => wasm.boundary_minimum(variant === 'roots' ? HL_ROOTS : HL_ROOTS_B),
        () => unpackMinimum(new Unpacker(output)),
      ),
    jacobian: (vertices, point) =>
      answer(vertices, point, wasm.jacobian_at, () => ({
        ...unpackJacobian(new Unpacker(output), point),
        ...exactJacdetAt(vertices, point),
      })),
  }
}
