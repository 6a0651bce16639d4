/** Certificates against the answers known from elsewhere, and against an independent checker that must also refuse. */
import { describe, expect, it } from 'vitest'
import { faces, type Vec3, type Vertices } from '../../web/model/hexahedron'
import { presets, presetVertices } from '../../web/model/presets'
import { certificateOf, checked, type Loose } from './certificate-checker'
import { cases, caseVertices, depthGuardCases, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { exactJacdet } from './exact'

const holding = (certificates: readonly Loose[]) => ({
  status: 0,
  output: `${certificates.length} certificates hold\n`,
  errors: '',
})

/** The same element with other names for its vertices: by a quarter turn about zeta, by a third of a turn about a diagonal. */
const quarterTurn = [1, 2, 3, 0, 5, 6, 7, 4]
const thirdOfATurn = [0, 3, 7, 4, 1, 2, 6, 5]
const turned = (vertices: Vertices, order: readonly number[]) =>
  order.flatMap(v => vertices.slice(3 * v, 3 * v + 3)) as Vertices
const rotations = (vertices: Vertices) =>
  [0, 1, 2, 3].flatMap(quarters =>
    [0, 1, 2].map(thirds => {
      let result = vertices
      for (let i = 0; i < quarters; ++i) result = turned(result, quarterTurn)
      for (let i = 0; i < thirds; ++i) result = turned(result, thirdOfATurn)
      return result
    }),
  )

describe('certificates', () => {
  it('of all exact cases agree with the answers and hold', () => {
    const certificates = cases.map(({ name, vertices }) => certificateOf(name, vertices.flat()))
    expect(certificates.map(({ valid }) => valid)).toEqual(cases.map(({ answer }) => answer.valid))
    for (const [i, { answer }] of cases.entries()) {
      const { valid, jacdet } = entry(certificates, i)
      if (!valid) expect(jacdet.startsWith('-') ? -1 : 0, entry(cases, i).name).toBe(answer.sign)
    }
    expect(checked(JSON.stringify(certificates), JSON.stringify(cases))).toEqual(holding(certificates))
  })

  it('of the valid elements that a depth guard rejects say valid and hold', () => {
    const certificates = depthGuardCases.map(({ name, vertices }) => certificateOf(name, vertices.flat()))
    expect(certificates.every(({ valid }) => valid)).toBe(true)
    expect(checked(JSON.stringify(certificates), JSON.stringify(depthGuardCases))).toEqual(holding(certificates))
  })

  it('of all presets agree with their claims and hold', () => {
    const random = randomSource(31)
    const certificates = presets.map(preset => certificateOf(preset.id, presetVertices(preset, random)))
    for (const [i, { id, valid }] of presets.entries())
      if (valid !== null) expect(entry(certificates, i).valid, id).toBe(valid)
    expect(checked(JSON.stringify(certificates))).toEqual(holding(certificates))
  })

  it('of random elements, of all scales and of mixed ones, hold', () => {
    const random = randomSource(32)
    const makers = [
      () => randomHexahedron(random, 0.3),
      () => randomHexahedron(random, 0.5).map(Math.round),
      () => randomHexahedron(random, 0.25).map((x, i) => x * entry([1e-200, 1e90, 3e-7], i % 3)),
      () => unitCube.map(x => (x === 1 && random() < 0.3 ? 1e40 : x)),
    ]
    const certificates = Array.from({ length: 240 }, (_, n) => certificateOf(`${n}`, entry(makers, n % 4)()))
    expect(certificates.filter(({ valid }) => valid).length).toBeGreaterThan(60)
    const greatest = Math.max(
      ...certificates.flatMap(each => (each.valid ? each.faces.map((f: Loose) => f.length) : [])),
    )
    expect(greatest).toBeGreaterThan(100)
    expect(checked(JSON.stringify(certificates))).toEqual(holding(certificates))
  })
})

describe('the point of an invalid element', () => {
  it('is one that a person can read', () => {
    const pointOf = (name: string) => {
      const { point, jacdet } = certificateOf(name, caseVertices(name))
      return [...point, jacdet].join(' ')
    }
    expect(pointOf('pub/degenerate/mirrored_swap')).toBe('0 0 0 -1')
    expect(pointOf('pub/corner_pos/three_moved')).toBe('0 0 5/8 -1/64')
    expect(pointOf('pub/edge_pos/s4_in_cube')).toBe('1/2 1/2 0 -1/16')
  })

  it('is exact where the least value is zero, on every face and edge', () => {
    const touching = [
      ...['corner', 'edge', 'face'].map(kind => caseVertices(`pub/touch_${kind}/0_zero`)),
      ...presets.filter(({ id }) => id === 'touching').map(preset => presetVertices(preset)),
    ]
    const certificates = touching.flatMap((vertices, i) =>
      rotations(vertices).map((each, j) => certificateOf(`${i} ${j}`, each)),
    )
    expect(certificates.every(({ jacdet }) => jacdet === '0')).toBe(true)
    const ofFace = certificates.slice(24, 36).map(({ point }) => point.join())
    expect(ofFace[0]).toBe('5/7,2/7,1')
    expect(new Set(ofFace).size).toBe(12)
    expect(checked(JSON.stringify(certificates))).toEqual(holding(certificates))
  })
})

type Coefficients = { readonly a: bigint; readonly b: bigint; readonly c: bigint }

/** a, b, c of a face at a t, times a positive number, from exact values at s = 0, 1/2, 1. */
function parabola(vertices: Vertices, face: number, t: number): Coefficients {
  const { axis, side, s: sAxis, t: tAxis } = entry(faces, face)
  const [start, half, end] = [0, 0.5, 1].map(s => {
    const point: [number, number, number] = [0, 0, 0]
    point[axis] = side
    point[sAxis] = s
    point[tAxis] = t
    return exactJacdet(vertices, point)
  }) as [bigint, bigint, bigint]
  return { a: 2n * start - 4n * half + 2n * end, b: -3n * start + 4n * half - end, c: start }
}

const conditions: Record<string, (at: Coefficients) => boolean> = {
  b: ({ b }) => b >= 0n,
  '2a+b': ({ a, b }) => 2n * a + b <= 0n,
  D: ({ a, b, c }) => 4n * a * c - b * b > 0n,
  middle: ({ b, c }) => 2n * c + b > 0n,
}

const number = (rational: string) => {
  const [numerator, denominator = 1] = rational.split('/').map(Number)
  return (numerator as number) / denominator
}

/** True if the condition is false at an end of the interval, so that no proof can rest on it. */
function isFalse(vertices: Vertices, face: number, { t, by }: Loose): boolean {
  return t.some((end: string) => !conditions[by]?.(parabola(vertices, face, number(end))))
}

const jacdetAt = (vertices: Vertices, point: readonly string[]) =>
  exactJacdet(vertices, point.map(number) as unknown as Vec3)

describe('one hundred tampered certificates', () => {
  const random = randomSource(33)
  const oneOf = <T>(list: readonly T[]): T => entry(list, Math.floor(random() * list.length))
  const elements = Array.from({ length: 400 }, (_, n) =>
    randomHexahedron(random, 0.4).map(x => (n % 2 ? Math.round(4 * x) / 4 : Math.round(64 * x) / 64)),
  )
  const all: Loose[] = elements.map((vertices, n) => certificateOf(`element ${n}`, vertices))
  const invalid = all.filter(
    ({ valid, point }) => !valid && point.every((x: string) => (number(x) * 2 ** 40) % 1 === 0),
  )
  const isInside = ({ point }: Loose) => point.some((x: string) => x.includes('/'))
  const valid = all.filter(each => each.valid)
  const several = valid.filter(each => each.faces.some((face: Loose) => face.length > 1))
  const longest = (each: Loose): number =>
    each.faces.reduce((best: number, face: Loose, i: number) => (face.length > each.faces[best].length ? i : best), 0)
  const flat = (each: Loose): Vertices => each.vertices.flat()

  /** Changes a copy; false where the change would not make it wrong. */
  type Tampering = readonly [what: string, from: readonly Loose[], change: (copy: Loose) => boolean | undefined]
  const set =
    (key: string, ...values: unknown[]) =>
    (copy: Loose) => {
      copy[key] = oneOf(values)
      return true
    }
  const without = (key: string) => (copy: Loose) => delete copy[key]
  const inFace = (change: (intervals: Loose, copy: Loose, face: number) => boolean | undefined) => (copy: Loose) => {
    const face = longest(copy)
    return change(copy.faces[face], copy, face)
  }
  const malformed = [
    '0.5',
    '1/0',
    '1/-2',
    ' 1/2',
    '2/4',
    '',
    '+1',
    '1e0',
    '1/2\n',
    '½',
    '٠',
    '-0',
    '0/1',
    'nan',
    0,
    null,
    ['0'],
  ]

  const tamperings: readonly Tampering[] = [
    [
      'a point moved',
      invalid,
      copy => {
        const before = jacdetAt(flat(copy), copy.point)
        copy.point[oneOf([0, 1, 2])] = oneOf(['1/2', '3/8', '1/64', '61/64'])
        return jacdetAt(flat(copy), copy.point) !== before
      },
    ],
    [
      'a point outside',
      invalid,
      copy => {
        copy.point[oneOf([0, 1, 2])] = oneOf(['-1', '2', '3/2', '-1/1024', '1025/1024'])
        return true
      },
    ],
    [
      'jacdet without its sign',
      invalid.filter(({ jacdet }) => jacdet !== '0'),
      copy => {
        copy.jacdet = copy.jacdet.slice(1)
        return true
      },
    ],
    ['another jacdet', invalid.filter(({ jacdet }) => jacdet !== '0'), set('jacdet', '0', '-1/1180591620717411303425')],
    [
      'a malformed coordinate',
      invalid,
      copy => {
        copy.point[oneOf([0, 1, 2])] = oneOf(malformed)
        return true
      },
    ],
    ['a malformed jacdet', invalid, set('jacdet', ...malformed)],
    ['a point of two or four', invalid, set('point', ['0', '0'], ['0', '0', '0', '0'], [], { 0: '0', 1: '0', 2: '0' })],
    ['a key missing', invalid, copy => delete copy[oneOf(['name', 'vertices', 'valid', 'point', 'jacdet'])]],
    [
      'invalid said to be valid',
      invalid,
      copy => {
        copy.valid = true
        copy.faces = oneOf(valid).faces
        return true
      },
    ],
    ['the other verdict alone', invalid, set('valid', true)],
    ['a verdict of another type', all, set('valid', 'false', 0, 1, null, 'true')],
    [
      'the vertices of another',
      invalid.filter(isInside),
      copy => {
        const before = jacdetAt(flat(copy), copy.point)
        copy.vertices = oneOf(all).vertices
        return jacdetAt(flat(copy), copy.point) !== before
      },
    ],
    [
      'valid said to be invalid',
      valid,
      copy => {
        copy.valid = false
        copy.point = [oneOf(['0', '1/2']), oneOf(['0', '1']), '1']
        copy.jacdet = oneOf(['0', '-1/64', '-1', '1'])
        return true
      },
    ],
    [
      'the vertices of an invalid one',
      valid,
      copy => {
        copy.vertices = oneOf(invalid).vertices
        return true
      },
    ],
    [
      'the mirror image',
      valid,
      copy => {
        copy.vertices = copy.vertices.map(([x, y, z]: Vec3) => [-x, y, z])
        return jacdetAt(flat(copy), ['0', '0', '0']) <= 0n
      },
    ],
    [
      'two vertices swapped',
      valid,
      copy => {
        const [v, w] = [oneOf([0, 1, 2, 3]), oneOf([4, 5, 6, 7])]
        ;[copy.vertices[v], copy.vertices[w]] = [copy.vertices[w], copy.vertices[v]]
        return [0, 1].some(i => jacdetAt(flat(copy), [`${i}`, '0', '0']) <= 0n)
      },
    ],
    [
      'another reason',
      several,
      inFace((intervals, copy, face) => {
        const interval = oneOf<Loose>(intervals)
        interval.by = oneOf(Object.keys(conditions))
        return isFalse(flat(copy), face, interval)
      }),
    ],
    [
      'no reason',
      valid,
      copy => {
        oneOf<Loose>(copy.faces)[0].by = oneOf(['a', '', 'c', null, 0, ['b'], 'Middle', '2a'])
        return true
      },
    ],
    [
      'an interval left out',
      several,
      inFace(intervals => intervals.splice(Math.floor(random() * intervals.length), 1)),
    ],
    ['intervals in another order', several, inFace(intervals => intervals.reverse())],
    [
      'intervals made one',
      several,
      inFace((intervals, copy, face) => {
        intervals.splice(0, intervals.length, { t: ['0', '1'], by: oneOf(Object.keys(conditions)) })
        return isFalse(flat(copy), face, intervals[0])
      }),
    ],
    [
      'a common end moved',
      several,
      inFace((intervals, copy, face) => {
        const i = Math.floor(random() * (intervals.length - 1))
        intervals[i].t[1] = intervals[i + 1].t[0] = oneOf(['1/1024', '1/16', '15/16', '1023/1024'])
        const moved = [intervals[i], intervals[i + 1]]
        return (
          moved.some(({ t }) => number(t[0]) >= number(t[1])) || moved.some(each => isFalse(flat(copy), face, each))
        )
      }),
    ],
    [
      'a common end that is not dyadic',
      several,
      inFace(intervals => {
        intervals[0].t[1] = intervals[1].t[0] = oneOf(['1/3', '1/7', '3/10'])
        return true
      }),
    ],
    [
      'a first end above 0',
      valid,
      copy => {
        oneOf<Loose>(copy.faces)[0].t[0] = oneOf(['1/2', '1/1048576', '1'])
        return true
      },
    ],
    [
      'a last end that is not 1',
      valid,
      copy => {
        oneOf<Loose>(copy.faces).at(-1).t[1] = oneOf(['3/4', '1048575/1048576', '2', '0'])
        return true
      },
    ],
    [
      'malformed ends',
      valid,
      copy => {
        oneOf<Loose>(copy.faces)[0].t = oneOf([
          ['0'],
          ['0', '1', '1'],
          [0, 1],
          '01',
          null,
          ['0', '1/0'],
          ['0/1', '1'],
          ['1', '0'],
        ])
        return true
      },
    ],
    ['a face missing', valid, copy => copy.faces.splice(oneOf([0, 1, 2, 3, 4, 5]), 1)],
    [
      'a face without intervals',
      valid,
      copy => {
        copy.faces[oneOf([0, 1, 2, 3, 4, 5])] = oneOf([[], null, {}, 'middle', [null], [[]]])
        return true
      },
    ],
    ['a seventh face', valid, copy => copy.faces.push(copy.faces[0])],
    [
      'two faces swapped',
      several,
      copy => {
        const [f, g] = [longest(copy), oneOf([0, 1, 2, 3, 4, 5])]
        ;[copy.faces[f], copy.faces[g]] = [copy.faces[g], copy.faces[f]]
        return [f, g].some(face => copy.faces[face].some((each: Loose) => isFalse(flat(copy), face, each)))
      },
    ],
    ['faces of another type', valid, set('faces', null, {}, 6, 'middle', [[], [], [], [], [], []])],
    [
      'a vertex too few or too many',
      all,
      copy => {
        if (random() < 0.5) copy.vertices.pop()
        else copy.vertices.push([0, 0, 0])
        return true
      },
    ],
    [
      'a coordinate that is none',
      all,
      copy => {
        oneOf<Loose>(copy.vertices)[oneOf([0, 1, 2])] = oneOf(['0', null, true, [0], { x: 0 }])
        return true
      },
    ],
    ['a name of another type', all, set('name', 3, null, ['x'])],
    ['the certificate of no element', valid, without('vertices')],
  ]

  const tampered: { what: string; text: string }[] = []
  for (let n = 0; tampered.length < 95; ++n) {
    const [what, from, change] = entry(tamperings, n % tamperings.length)
    const copy = structuredClone(oneOf(from))
    if (!change(copy)) continue
    const text = JSON.stringify(copy)
    if (tampered.every(other => other.text !== text)) tampered.push({ what, text })
  }
  const byHand = (what: string, certificate: object) => tampered.push({ what, text: JSON.stringify(certificate) })
  const box = [0, 1, 2, 3, 4, 5, 6, 7].map(v => unitCube.slice(3 * v, 3 * v + 3))
  byHand('a true value that is positive', {
    name: 'cube',
    vertices: box,
    valid: false,
    point: ['0', '0', '0'],
    jacdet: '1',
  })
  // The vertices of one zeta-edge are across the diagonal: jacdet is -1/4 on it and affine in xi
  // and eta, of slopes 5/8.
  const everywhere = (by: string) => Array.from({ length: 6 }, () => [{ t: ['0', '1'], by }])
  const dented = (corner: number, to: number) =>
    box.map(([x, y, z]) => (x === corner && y === corner ? [to, to, z] : [x, y, z]))
  byHand('an edge at s = 0', { name: 'dent', vertices: dented(0, 5 / 8), valid: true, faces: everywhere('b') })
  byHand('an edge at s = 1', { name: 'dent', vertices: dented(1, 3 / 8), valid: true, faces: everywhere('2a+b') })
  // jacdet = (2 - zeta)^2 is zero at zeta = 2 as it says, which is not in the cube.
  const frustum = [
    [0, 0, 0],
    [2, 0, 0],
    [2, 2, 0],
    [0, 2, 0],
    [0, 0, 1],
    [1, 0, 1],
    [1, 1, 1],
    [0, 1, 1],
  ]
  byHand('a true value outside', {
    name: 'frustum',
    vertices: frustum,
    valid: false,
    point: ['0', '0', '2'],
    jacdet: '0',
  })
  const huge = JSON.stringify(oneOf(all))
    .replace('"vertices":[[', '"vertices":[[1e999,')
    .replace(/(1e999,)[^,]*,/, '$1')
  tampered.push({ what: 'a coordinate beyond the doubles', text: huge })

  it('of every kind are each refused, with a sentence', () => {
    expect(tampered.length).toBe(100)
    expect(new Set(tampered.map(({ what }) => what)).size).toBe(tamperings.length + 5)
    expect(checked(JSON.stringify(all))).toEqual(holding(all))
    const { status, output, errors } = checked(`[${tampered.map(({ text }) => text).join()}]`)
    expect([status, errors]).toEqual([1, ''])
    const lines = output.trimEnd().split('\n')
    const refused = new Set(lines.map(line => /^refused: certificate (\d+) \(.*\): .+$/.exec(line)?.[1]))
    expect(tampered.filter((_, i) => !refused.has(`${i}`))).toEqual([])
    expect(lines.length).toBe(100)
  })

  it('and others that are no certificates at all end in a line each, not in a traceback', () => {
    const junk = [null, true, 'x', [], {}, { error: 'x' }, { name: '\n"', vertices: [] }, { vertices: [[[]]] }]
    const places = (node: Loose): [Loose, string][] =>
      typeof node === 'object' && node !== null
        ? Object.keys(node).flatMap(key => [[node, key] as [Loose, string], ...places(node[key])])
        : []
    const broken = Array.from({ length: 300 }, () => {
      const copy = structuredClone(oneOf(all))
      const [node, key] = oneOf(places(copy).filter(([, key]) => key !== 'theorem' && key !== 'name'))
      node[key] = oneOf(junk)
      return copy
    })
    const wrong = [...junk, ...broken]
    const { status, output, errors } = checked(JSON.stringify(wrong))
    expect([status, errors]).toEqual([1, ''])
    expect(output.trimEnd().split('\n').length).toBe(wrong.length)
  })
})

describe('the checker', () => {
  const [one, two] = ['pub/degenerate/cube', 'pub/corner_pos/three_moved'].map(name =>
    certificateOf(name, caseVertices(name)),
  )
  const list = JSON.stringify([one, two])

  it('compares with the elements: number, names, order, doubles', () => {
    expect(checked(list, list)).toEqual(holding([one, two]))
    const swapped = checked(list, JSON.stringify([two, one]))
    expect(swapped.status).toBe(1)
    expect(swapped.output).toMatch(/^refused: .+ another name\nrefused: .+ another name\n$/)
    const next = structuredClone(two)
    next.vertices[6][2] *= 1 + Number.EPSILON
    expect(checked(list, JSON.stringify([one, next])).output).toMatch(/^refused: certificate 1 .+ other vertices\n$/)
    expect(checked(list, JSON.stringify([one])).errors).toMatch(/^refused: .+ not lists of the same length\n$/)
  })

  it('reads coordinates as the doubles that JavaScript writes', () => {
    const big = certificateOf('big', [...unitCube.map(x => x * 2 ** 69)])
    expect(JSON.stringify(big)).toContain('590295810358705700000')
    expect(big.valid).toBe(true)
    const flattened = certificateOf('flat', [...unitCube.map((x, i) => (i === 14 ? -x : x * 2 ** 69))])
    expect(checked(JSON.stringify([big, flattened]))).toEqual(holding([big, flattened]))
  })

  it('refuses what it cannot read in one line', () => {
    for (const text of ['', '{', '{}', '3', `${'['.repeat(100000)}`, '\u0000'])
      expect(checked(text)).toMatchObject({ status: 1, output: '', errors: expect.stringMatching(/^refused: .+\n$/) })
    expect(checked('[]')).toEqual(holding([]))
  })
})
