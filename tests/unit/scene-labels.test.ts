import { describe, expect, it } from 'vitest'
import {
  convexHull,
  type LabelRequest,
  numberDirection,
  overlap,
  placeLabel,
} from '../../web/scene/overlay/label-place'

const request: LabelRequest = {
  anchor: { x: 200, y: 150 },
  width: 100,
  height: 20,
  bounds: { x: 0, y: 0, width: 400, height: 300 },
  points: [],
  numbers: [],
  boxes: [],
  body: [],
  previous: null,
}

function boxOf(asked: LabelRequest) {
  const { x, y } = placeLabel(asked)
  return { x: x - asked.width / 2, y: y - asked.height / 2, width: asked.width, height: asked.height }
}

describe('a label', () => {
  it('stays inside the view wherever its point is', () => {
    for (const anchor of [
      { x: 2, y: 2 },
      { x: 398, y: 150 },
      { x: 200, y: 298 },
    ]) {
      const box = boxOf({ ...request, anchor })
      expect(box.x).toBeGreaterThanOrEqual(0)
      expect(box.y).toBeGreaterThanOrEqual(0)
      expect(box.x + box.width).toBeLessThanOrEqual(400)
      expect(box.y + box.height).toBeLessThanOrEqual(300)
    }
  })

  it('keeps clear of handles and of what is taken', () => {
    const taken = { x: 200, y: 0, width: 200, height: 300 }
    const handle = { x: 110, y: 150 }
    const box = boxOf({ ...request, boxes: [taken], points: [handle] })
    expect(overlap(box, taken)).toBe(false)
    const inside = handle.x > box.x && handle.x < box.x + box.width && handle.y > box.y && handle.y < box.y + box.height
    expect(inside).toBe(false)
  })

  it('goes away from the middle of the body, off it', () => {
    const body = [
      { x: 100, y: 120 },
      { x: 200, y: 120 },
      { x: 200, y: 200 },
      { x: 100, y: 200 },
    ]
    expect(placeLabel({ ...request, body }).x).toBeGreaterThan(200)
  })

  it('says when no place is free', () => {
    const left = { x: 0, y: 0, width: 150, height: 300 }
    expect(placeLabel({ ...request, boxes: [left] }).isFree).toBe(true)
    expect(placeLabel({ ...request, boxes: [left, { ...left, x: 150, width: 250 }] }).isFree).toBe(false)
    expect(placeLabel({ ...request, width: 500 }).isFree).toBe(false)
  })

  it('does not jump for a small gain', () => {
    const first = placeLabel(request)
    const moved = { ...request, anchor: { x: 203, y: 149 }, previous: first.index }
    expect(placeLabel(moved).index).toBe(first.index)
  })
})

describe('the convex hull', () => {
  it('leaves out what is inside and doubled', () => {
    const corners = [
      { x: 0, y: 0 },
      { x: 4, y: 0 },
      { x: 4, y: 4 },
      { x: 0, y: 4 },
    ]
    const hull = convexHull([...corners, { x: 2, y: 2 }, { x: 4, y: 4 }])
    expect(hull).toHaveLength(4)
    expect(hull).toEqual(expect.arrayContaining(corners))
  })
})

it('a number goes outwards, and aside where another one or a taken box is', () => {
  const [at, up] = [
    { x: 100, y: 100 },
    { x: 0, y: -1 },
  ]
  expect(numberDirection(at, up, 17, [], [])).toEqual(up)
  expect(numberDirection(at, up, 17, [{ x: 130, y: 83 }], [])).toEqual(up)
  const other = { x: 103, y: 85 }
  const { x, y } = numberDirection(at, up, 17, [other], [])
  expect(Math.hypot(x, y)).toBeCloseTo(1)
  expect(Math.hypot(100 + 17 * x - other.x, 100 + 17 * y - other.y)).toBeGreaterThan(13)
  const bar = { x: 0, y: 0, width: 200, height: 84 }
  expect(at.y + 17 * numberDirection(at, up, 17, [], [bar]).y).toBeGreaterThan(84)
})
