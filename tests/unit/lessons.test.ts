/** The lessons as content: every claim at its step's own element, formulas, links, and what the lens is asked to show. */
import { describe, expect, it } from 'vitest'
import { facePolynomials, valueAt } from '../../web/core/face-polynomials'
import { quantitiesOf } from '../../web/core/quantities'
import type { Candidate } from '../../web/core/report'
import { bernsteinOnEdge, gradientInside, valueInside } from '../../web/core/section'
import { isMet, parseCondition } from '../../web/model/condition'
import { faces as topology, type Vec3, vertexOf, vertexReference } from '../../web/model/hexahedron'
import { readState } from '../../web/model/state-document'
import { addressOf, complaintAbout, hashOf, neighbour, type StepAddress, stepAt } from '../../web/pages/lessons/address'
import { isInPlane, lessons } from '../../web/pages/lessons/content/lessons'
import { shownStep, stateOf, verticesOf } from '../../web/pages/lessons/step-state'
import { panels } from '../../web/panels/list'
import { knownPanels } from '../../web/panels/panel'
import { core, entry, randomSource, unitCube } from './core-fixtures'

const addresses: readonly StepAddress[] = lessons.flatMap(lesson => lesson.steps.map((_, step) => ({ lesson, step })))
const steps = addresses.map(address => ({ name: hashOf(address), step: entry(address.lesson.steps, address.step) }))

const hexahedronSteps = steps.flatMap(({ name, step }) => (isInPlane(step) ? [] : [{ name, step }]))

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

it('a lesson 0 and six more, in the order in which they build on each other', () => {
  expect(lessons.map(({ id }) => id)).toEqual([
    'quadrilaterals-first',
    'what-the-jacobian-determinant-is',
    'corners-are-not-enough',
    'edges-are-not-enough',
    'faces-are-enough',
    'strictly',
    'finding-the-minimum',
  ])
})

it('every link leads to its step and no two to the same, others to the beginning of the lesson or to the overview', () => {
  expect(new Set(addresses.map(hashOf)).size).toBe(addresses.length)
  for (const address of addresses) expect(addressOf(hashOf(address))).toEqual(address)
  for (const hash of ['', '#', '#nowhere/2']) expect(addressOf(hash)).toBeNull()
  for (const hash of ['#strictly/0', '#strictly/99', '#strictly/x', '#strictly'])
    expect(addressOf(hash)).toEqual({ lesson: lessons[5], step: 0 })
})

it('a link that names no step is complained of, with what it names', () => {
  for (const hash of ['', '#', '#strictly', ...addresses.map(hashOf)]) expect(complaintAbout(hash)).toBeNull()
  expect(complaintAbout('#nowhere/2')).toBe('There is no lesson “nowhere”. These are the lessons that there are.')
  for (const step of ['0', '99', 'x', '1.5', '01'])
    expect(complaintAbout(`#strictly/${step}`)).toBe(`This lesson has no step “${step}”. This is its first.`)
})

it('forwards from the first step one comes through all of them, and back', () => {
  for (const [i, address] of addresses.entries()) {
    expect(neighbour(address, 1)).toEqual(addresses[i + 1] ?? null)
    expect(neighbour(address, -1)).toEqual(addresses[i - 1] ?? null)
  }
})

const known = knownPanels(panels)

describe('every step', () => {
  it.each(steps)('$name: what it claims is so', ({ step }) => {
    const vertices = verticesOf(step)
    const quantities = quantitiesOf(reportOf(vertices), vertices)
    for (const { says, holds } of step.claims) {
      const condition = parseCondition(holds)
      expect(condition.ok, holds).toBe(true)
      if (condition.ok) expect(isMet(condition.value, quantities), `${says}: ${holds}`).toBe(true)
    }
  })

  it.each(hexahedronSteps)('$name: the lens understands it', ({ step }) => {
    const result = readState(stateOf(step), known)
    expect(result).toMatchObject({ ok: true })
    if (result.ok) {
      const { cameras, slices } = result.value
      expect({ ...result.value, ...cameras, ...Object.assign({}, ...Object.values(slices)) }).toMatchObject(
        step.state ?? {},
      )
    }
    const views = step.views.split(' ')
    expect(views).toContain('scene')
    for (const panel of step.state?.openPanels ?? []) expect(views).toContain(panel)
  })

  it.each(steps)('$name: plain words, and formulas that are well formed', ({ step }) => {
    expect(step.title).not.toMatch(/[.<]/)
    const { asks = '', because = '' } = step.question ?? {}
    for (const html of [step.text, `<p>${step.task}</p>`, asks, because]) {
      expect(unclosed(html)).toEqual([])
      expect(html.match(/<math/g) ?? []).toHaveLength((html.match(/<\/math>/g) ?? []).length)
      for (const formula of html.match(/<math[\s\S]*?<\/math>/g) ?? []) {
        const texts = formula.replace(/<(mi|mn|mo|mtext)\b[^>]*>[^<]+<\/\1>/g, '').replace(/<[^>]+>/g, '')
        expect(texts, formula).toBe('')
      }
      expect(html.replace(/<[^>]*>/g, ''), 'a true minus sign').not.toMatch(/(^|\s)-\d/)
    }
    expect(step.task).toMatch(/[.?]$/)
    for (const { says } of step.claims) expect(says).not.toMatch(/[.]$/)
  })
})

/** Names of elements that are not closed in their order. */
function unclosed(html: string): string[] {
  const open: string[] = []
  for (const [, slash, name = ''] of html.matchAll(/<(\/?)([a-z]+)[^>]*>/g)) {
    if (!slash) open.push(name)
    else if (open.pop() !== name) return [...open, `/${name}`]
  }
  return open
}

describe('what the texts say besides', () => {
  const elementOf = (hash: string) => verticesOf(stepAt(addressOf(hash) as StepAddress))

  it('vertex 6 of the cube at (t, t, t) has jacdet 3t − 2', () => {
    for (const t of [2, 1.5, 0.75, 0.5, 0.25]) {
      const vertices = unitCube.map((x, i) => (Math.floor(i / 3) === 6 ? t : x))
      expect(reportOf(vertices).bernstein.at(-1)).toBe(3 * t - 2)
    }
  })

  it('with vertex 6 at (t, t, t) the Gauss point next to it turns at t = 0.464', () => {
    const gauss = (1 + Math.sqrt(1 / 3)) / 2
    expect(gauss.toFixed(3)).toBe('0.789')
    expect((3 * gauss ** 2).toFixed(3)).toBe('1.866')
    const turns = 1 - 1 / (3 * gauss ** 2)
    expect(turns.toFixed(3)).toBe('0.464')
    const own = elementOf('#corners-are-not-enough/5')
    const leastAt = (t: number) => {
      const { bernstein, checks } = reportOf(own.map((x, i) => (Math.floor(i / 3) === 6 ? t : x)))
      const [x, y, z] = [0.3, 0.6, 0.9]
      expect(valueInside(bernstein, [x, y, z])).toBeCloseTo(1 + (t - 1) * (y * z + x * z + x * y), 12)
      return checks.find(({ id }) => id === 'gauss-2')?.value ?? Number.NaN
    }
    expect(leastAt(turns + 1e-6)).toBeGreaterThan(0)
    expect(leastAt(turns - 1e-6)).toBeLessThan(0)
  })

  it('half of the way to the element with a negative face all faces are positive', () => {
    const preset = pointsOf(elementOf('#edges-are-not-enough/3'))
    const half = preset.flatMap((point, v) => point.map((x, i) => (x + at(vertexReference[v] as Vec3, i)) / 2))
    const asked = stepAt(addressOf('#edges-are-not-enough/2') as StepAddress)
    expect(verticesOf(shownStep(asked, true))).toEqual(half)
    expect(reportOf(half).valid).toBe(true)
  })

  it('an edge whose tangents meet below zero is positive', () => {
    expect(bernsteinOnEdge(reportOf(elementOf('#edges-are-not-enough/1')).bernstein, 2)).toEqual([1, -1 / 2, 1])
  })

  it('an edge is positive exactly by its three coefficients, least where the formula says', () => {
    const random = randomSource(11)
    for (let n = 0; n < 300; ++n) {
      const [q0, q1, q2] = [2 * random() - 0.2, 2 * random() - 1.5, 2 * random() - 0.2] as const
      const at = (r: number) => (1 - r) ** 2 * q0 + 2 * r * (1 - r) * q1 + r * r * q2
      const least = q1 < q0 && q1 < q2 ? at((q0 - q1) / (q0 - 2 * q1 + q2)) : Math.min(q0, q2)
      for (let k = 0; k <= 50; ++k) expect(at(k / 50)).toBeGreaterThanOrEqual(least - 1e-12)
      expect(q0 > 0 && q2 > 0 && (q1 >= 0 || q1 * q1 < q0 * q2)).toBe(least > 0)
    }
  })

  it('a quarter turn and a reflection map the element with a negative face to itself', () => {
    const points = pointsOf(elementOf('#edges-are-not-enough/2'))
    const turned = points.map(([x, y, z]) => [1 - y, x, 1 - z])
    expect(turned.toSorted().join(';')).toBe(points.toSorted().join(';'))
  })

  it('the slopes at the ends of the tube’s section have one sign each, and jacdet does not change across', () => {
    const { bernstein } = reportOf(elementOf('#faces-are-enough/5'))
    const atXi = (xi: number) => valueInside(bernstein, [xi, 0.5, 0.5])
    let [inside, outside] = [0.5, 0]
    while (inside - outside > 1e-15) {
      const middle = (inside + outside) / 2
      if (atXi(middle) < 0) inside = middle
      else outside = middle
    }
    for (const [xi, sign] of [
      [inside, -1],
      [1 - inside, 1],
    ] as const) {
      const [slope, ...across] = gradientInside(bernstein, [xi, 0.5, 0.5])
      expect(Math.sign(slope)).toBe(sign)
      for (const value of across) expect(value).toBeCloseTo(0, 12)
    }
  })

  it('where jacdet and its change with η and ζ are zero, its slope in ξ is −2αβκ', () => {
    const random = randomSource(5)
    const vector = (): Vec3 => [2 * random() - 1, 2 * random() - 1, 2 * random() - 1]
    for (let n = 0; n < 100; ++n) {
      const [alpha, beta] = vector()
      const [v, w, c, d] = [vector(), vector(), vector(), vector()]
      const u = sum(scaled(v, alpha), scaled(w, beta))
      const kappa = determinant(v, w, c)
      // A and B meet the two conditions along the normal of V and W.
      const normal = cross(v, w)
      const along = (value: number) => scaled(normal, value / dot(normal, normal))
      const [a, b] = [sum(along(beta * kappa), scaled(v, d[0])), sum(along(alpha * kappa), scaled(w, d[1]))]
      // F = Ux + Vy + Wz + Axy + Bxz + Cyz + Dxyz about the point, which is the vertex 0 of this element.
      const vertices = vertexReference.flatMap(([x, y, z]) =>
        [0, 1, 2].map(
          i =>
            at(u, i) * x +
            at(v, i) * y +
            at(w, i) * z +
            at(a, i) * x * y +
            at(b, i) * x * z +
            at(c, i) * y * z +
            at(d, i) * x * y * z,
        ),
      )
      const { bernstein } = reportOf(vertices)
      expect(valueInside(bernstein, [0, 0, 0])).toBeCloseTo(0, 12)
      const [slope, ...across] = gradientInside(bernstein, [0, 0, 0])
      for (const value of across) expect(value).toBeCloseTo(0, 12)
      expect(slope).toBeCloseTo(-2 * alpha * beta * kappa, 12)
      // The steps of the calculation.
      expect(determinant(a, v, w)).toBeCloseTo(beta * kappa, 12)
      expect(determinant(b, v, w)).toBeCloseTo(alpha * kappa, 12)
      expect(determinant(u, a, w) + determinant(u, v, b)).toBeCloseTo(slope, 12)
    }
  })

  it('at the centre of the paper’s element no vector is mapped to less than half its length, and no move of d moves it by 2d', () => {
    const random = randomSource(29)
    for (let n = 0; n < 300; ++n) {
      const [a, b, c] = [random() - 0.5, random() - 0.5, random() - 0.5]
      const image = Math.hypot(b + c, a + c, a + b) / 2
      expect(image ** 2).toBeCloseTo((a * a + b * b + c * c + (a + b + c) ** 2) / 4, 12)
      expect(image).toBeGreaterThanOrEqual(Math.hypot(a, b, c) / 2 - 1e-12)
      const signed = [-1, 1].flatMap(i => [-1, 1].flatMap(j => [-1, 1].map(k => i * a + j * b + k * c)))
      expect(signed.reduce((total, value) => total + value ** 2, 0) / 8).toBeCloseTo(a * a + b * b + c * c, 12)
      const most = signed.reduce((total, value) => total + Math.abs(value), 0) / 4
      expect(most).toBeLessThanOrEqual(2 * Math.hypot(a, b, c) + 1e-12)
    }
  })

  it('along the curve s*(t) of a face the slope of jacdet by t is P/(4a²)', () => {
    const { faces } = reportOf(elementOf('#finding-the-minimum/3'))
    const { bernstein, quartic, quarticExponent } = entry(faces, 4)
    const polynomials = facePolynomials(bernstein)
    const leastAt = (t: number) => {
      const [a, b, c] = [polynomials.a, polynomials.b, polynomials.c].map(of => valueAt(of, t)) as [
        number,
        number,
        number,
      ]
      return (c - b ** 2 / (4 * a)) * 2 ** polynomials.exponent
    }
    for (const t of [0.2, 0.35, 0.5, 0.7]) {
      const a = valueAt(polynomials.a, t) * 2 ** polynomials.exponent
      const slope = (valueAt(quartic, t) * 2 ** quarticExponent) / (4 * a * a)
      expect((leastAt(t + 1e-5) - leastAt(t - 1e-5)) / 2e-5).toBeCloseTo(slope, 6)
    }
  })

  it('the paper’s element has the jacdet of the formula, and moves of less than 1/4 leave it invalid', () => {
    const vertices = elementOf('#strictly/1')
    const { bernstein } = reportOf(vertices)
    const random = randomSource(17)
    for (let n = 0; n < 100; ++n) {
      const [x, y, z] = [random(), random(), random()]
      expect(valueInside(bernstein, [x, y, z])).toBeCloseTo((1 - x - y - z) ** 2 - 4 * x * y * z, 12)
      const moved = pointsOf(vertices).flatMap(point => {
        const by: Vec3 = [random() - 0.5, random() - 0.5, random() - 0.5]
        const size = (0.2499 * (n % 2 === 0 ? 1 : random())) / Math.hypot(...by)
        return point.map((value, i) => value + size * at(by, i))
      })
      const report = reportOf(moved)
      expect(report.valid).toBe(false)
      expect(valueInside(report.bernstein, [0.5, 0.5, 0.5])).toBeLessThan(0)
    }
  })

  it('the candidates on the side faces are saddles at 1/16, and P is zero where a line is lowest', () => {
    const { candidates, faces, bernstein } = reportOf(elementOf('#finding-the-minimum/5'))
    for (const id of [0, 1, 2, 3]) {
      const { value, point } = candidates.find(({ kind, id: face }) => kind === 'face' && face === id) as Candidate
      expect(value).toBe(1 / 16)
      const { s, t } = entry(topology, id)
      const along = (ds: number, dt: number) =>
        valueInside(bernstein, point.map((x, i) => x + (i === s ? ds : i === t ? dt : 0)) as unknown as Vec3)
      expect(along(0.05, 0)).toBeGreaterThan(value)
      expect(Math.min(along(0.05, 0.1), along(-0.05, 0.1))).toBeLessThan(value)
      expect(entry(faces, id).roots.map(({ fate }) => fate)).toEqual(['kept'])
    }
    expect(reportOf(elementOf('#finding-the-minimum/6')).faces.every(({ quarticIsZero }) => quarticIsZero)).toBe(true)
    expect(reportOf(elementOf('#finding-the-minimum/7')).faces.every(face => face.skippedByMinimumRule)).toBe(true)
  })
})

const at = (vector: readonly number[], i: number) => entry(vector, i)
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const sum = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
const scaled = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by]
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const determinant = (a: Vec3, b: Vec3, c: Vec3) => dot(cross(a, b), c)

function pointsOf(vertices: readonly number[]): Vec3[] {
  return vertexReference.map((_, v) => vertexOf(vertices, v))
}

it('where a vertex is to be dragged along the diagonal, the diagonal is seen from the side', () => {
  const camera = stateOf(entry(entry(lessons, 1).steps, 5)).camera as { readonly direction: Vec3 }
  const [x, y, z] = camera.direction
  expect(Math.abs(x + y + z) / (Math.hypot(x, y, z) * Math.sqrt(3))).toBeLessThan(0.6)
})
