/**
 * Random numbers that are the same in every engine: only + - * /, square roots and integers, which all round alike. The generator is
 * xoshiro128** of D. Blackman and S. Vigna; normal numbers are by the ziggurat of J. Doornik, "An improved ziggurat method to generate
 * normal random samples" (2005), with a logarithm of our own.
 */

export interface Random {
  /** Uniform in [0, 1), a multiple of 2^-32. */
  unit(): number
  /** Fills a list with such numbers. */
  units(list: Float64Array): void
  /** Fills a list with numbers of mean 0 and deviation 1. */
  normals(list: Float64Array): void
}

/** Words made at once: a loop over locals is several times faster than one word at a time. */
const BLOCK = 2048

/** One stream for each pair of integers in [0, 2^32). */
export function randomOf(seed: number, stream: number): Random {
  const words = new Int32Array(BLOCK)
  let [a, b, c, d] = stateOf(seed, stream)
  let next = BLOCK

  function refill(): void {
    let [s0, s1, s2, s3] = [a, b, c, d]
    for (let i = 0; i < BLOCK; ++i) {
      const product = Math.imul(s1, 5)
      words[i] = Math.imul((product << 7) | (product >>> 25), 9)
      const shifted = s1 << 9
      s2 ^= s0
      s3 ^= s1
      s1 ^= s2
      s0 ^= s3
      s2 ^= shifted
      s3 = (s3 << 11) | (s3 >>> 21)
    }
    a = s0
    b = s1
    c = s2
    d = s3
    next = 0
  }

  /** An integer in [-2^31, 2^31). */
  function word(): number {
    if (next === BLOCK) refill()
    return words[next++] as number
  }

  const unit = () => word() / 2 ** 32 + 0.5
  const positiveUnit = () => unit() + 2 ** -33

  function units(list: Float64Array): void {
    for (let i = 0; i < list.length; ++i) list[i] = word() / 2 ** 32 + 0.5
  }

  function normals(list: Float64Array): void {
    for (let i = 0; i < list.length; ++i) {
      const u = word() / 2 ** 31
      const layer = word() & (LAYERS - 1)
      const x = u * (EDGES[layer] as number)
      list[i] = Math.abs(x) < (EDGES[layer + 1] as number) ? x : nearEdge(u, layer)
    }
  }

  /** A number in the layer where its rectangle is not all below the curve, which is rare. */
  function nearEdge(u: number, layer: number): number {
    if (layer === 0) return u < 0 ? -tail() : tail()
    const x = u * (EDGES[layer] as number)
    const below = HEIGHTS[layer] as number
    const height = below + ((HEIGHTS[layer + 1] as number) - below) * positiveUnit()
    if (logarithm(height) < -0.5 * x * x) return x
    const again = new Float64Array(1)
    normals(again)
    return again[0] as number
  }

  /** Beyond the base layer, by Marsaglia's method (1964). */
  function tail(): number {
    for (;;) {
      const x = -logarithm(positiveUnit()) / BASE
      if (-2 * logarithm(positiveUnit()) > x * x) return BASE + x
    }
  }

  return { unit, units, normals }
}

/** Not all zero: splitmix32 counts through all words, in an order that the seeds shift. */
function stateOf(seed: number, stream: number): [number, number, number, number] {
  let key = mixed(mixed(seed) ^ stream)
  const word = () => {
    key = (key + 0x9e3779b9) | 0
    return mixed(key)
  }
  return [word(), word(), word(), word() ^ seed ^ Math.imul(stream, 0x85ebca6b)]
}

/** A permutation of the words in which every bit depends on all: the finalizer of MurmurHash3. */
function mixed(word: number): number {
  const x = Math.imul(word ^ (word >>> 16), 0x85ebca6b)
  const y = Math.imul(x ^ (x >>> 13), 0xc2b2ae35)
  return y ^ (y >>> 16)
}

const LAYERS = 128
/** Doornik's: where the base layer ends, and the area of each layer under exp(-x^2/2). */
const BASE = 3.442619855899
const AREA = 9.91256303526217e-3
/** exp(-BASE^2/2). */
const BASE_HEIGHT = 0.002669629083880923

const double = new Float64Array(1)
const halves = new Uint32Array(double.buffer)
/** The index of the half with the exponent: engines store doubles as the machine does. */
const HIGH = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1 ? 1 : 0

/**
 * The natural logarithm of a normal double x > 0, to 1e-13 of itself or 1e-15: x = 2^e m with m in [1/sqrt 2, sqrt 2), and log m is
 * 2 (z + z^3/3 + z^5/5 + ...) for z = (m - 1)/(m + 1). |z| <= 0.1716, so what is left out after z^15 is below 2^-44 of the sum.
 */
export function logarithm(x: number): number {
  double[0] = x
  const high = halves[HIGH] as number
  halves[HIGH] = (high & 0xfffff) | 0x3ff00000
  const isHigh = (double[0] as number) > Math.SQRT2
  const m = isHigh ? (double[0] as number) / 2 : (double[0] as number)
  const exponent = (high >>> 20) - (isHigh ? 1022 : 1023)
  const z = (m - 1) / (m + 1)
  const w = z * z
  const series = 1 + w * (1 / 3 + w * (1 / 5 + w * (1 / 7 + w * (1 / 9 + w * (1 / 11 + w * (1 / 13 + w * (1 / 15)))))))
  return exponent * Math.LN2 + 2 * z * series
}

/** Right edges of the layers, the base layer as wide as its area says, down to 0; and exp(-x^2/2) there. */
const EDGES = new Float64Array(LAYERS + 1)
const HEIGHTS = new Float64Array(LAYERS + 1)
EDGES.set([AREA / BASE_HEIGHT, BASE])
HEIGHTS.set([0, BASE_HEIGHT])
for (let i = 2; i < LAYERS; ++i) {
  HEIGHTS[i] = AREA / (EDGES[i - 1] as number) + (HEIGHTS[i - 1] as number)
  EDGES[i] = Math.sqrt(-2 * logarithm(HEIGHTS[i] as number))
}
HEIGHTS[LAYERS] = 1
