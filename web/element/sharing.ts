/**
 * Elements of one `group` have one element, one camera and one point that is pointed at, as far as both of two `share` it. In the
 * frame in which one of them has changed, the others follow and are drawn. What they follow is no news of theirs.
 */
import type { Action, CameraView, ChangeSource, History, State } from '../model/state'

export const SHARED = ['vertices', 'camera', 'probe'] as const
export type Shared = (typeof SHARED)[number]

export interface SharingHost {
  readonly state: () => State
  readonly history: () => History
  /** As it was last seen; null before the first picture. */
  readonly camera: () => CameraView | null
  /** Whose its last change was. */
  readonly source: () => ChangeSource
  readonly dispatch: (action: Action, source: ChangeSource) => void
  readonly lookFrom: (camera: CameraView) => void
  /** Draws what is new in this very frame. */
  readonly draw: (time: number) => void
}

/** Members by the names of groups, in the order in which they joined. */
const groups = new Map<string, Set<Sharing>>()

type Known = Readonly<Record<Shared, readonly unknown[]>>

export class Sharing {
  name: string | null = null
  kinds: readonly Shared[] = SHARED
  readonly #host: SharingHost
  /** The group's; null outside one. */
  #members: Set<Sharing> | null = null
  /** What the group knows of this one. */
  #known: Known
  #isFollowing = false

  constructor(host: SharingHost) {
    this.#host = host
    this.#known = this.#now()
  }

  /** Takes what the group has; leaves another first. */
  join(): void {
    this.leave()
    if (!this.name) return
    const members = groups.get(this.name) ?? new Set()
    groups.set(this.name, members)
    const [first] = members
    members.add(this)
    this.#members = members
    if (first) this.#follow(first, SHARED)
    this.#known = this.#now()
  }

  /** What it points at is not pointed at any more. */
  leave(): void {
    if (this.#members === null) return
    if (this.kinds.includes('probe')) this.#host.dispatch({ type: 'probe', point: null }, 'program')
    this.tell(null)
    this.#members.delete(this)
    if (this.#members.size === 0) groups.delete(this.name ?? '')
    this.#members = null
  }

  /** Called after each frame with its time; null in none. */
  tell(time: number | null): void {
    if (this.#members === null || this.#isFollowing) return
    const before = this.#known
    this.#known = this.#now()
    const others = [...this.#members].filter(other => other !== this)
    let news = SHARED.filter(kind => this.#known[kind].some((value, i) => value !== before[kind][i]))
    const seen = others.find(other => other.#host.camera() !== null)
    const isFirst = before.camera[0] === null && news.includes('camera')
    // After its first picture it looks as the others do.
    if (isFirst && seen) {
      this.#follow(seen, ['camera'])
      news = news.filter(kind => kind !== 'camera')
    }
    for (const other of others) other.#hear(this, news, time)
  }

  #hear(from: Sharing, news: readonly Shared[], time: number | null): void {
    if (!this.#follow(from, news)) return
    this.#known = this.#now()
    if (time === null) return
    this.#isFollowing = true
    this.#host.draw(time)
    this.#isFollowing = false
    this.#known = { ...this.#known, camera: this.#now().camera }
  }

  /** Returns whether there was anything to follow. */
  #follow(other: Sharing, news: readonly Shared[]): boolean {
    const both = news.filter(kind => this.kinds.includes(kind) && other.kinds.includes(kind))
    const theirs = other.#host
    const { lookFrom, state } = this.#host
    const source = theirs.source()
    const dispatch = (action: Action) => this.#host.dispatch(action, source)
    const { gestureStart, vertices, probe, isVertexChosen, selectedVertex } = theirs.state()
    if (both.includes('vertices')) {
      if (gestureStart === null) {
        dispatch({ type: 'commit-gesture' }) // what is there already stays the same array
        dispatch({ type: 'take-history', history: theirs.history() })
      } else {
        if (state().gestureStart === null) dispatch({ type: 'begin-gesture' })
        dispatch({ type: 'move-all', vertices })
      }
      dispatch({ type: 'select-vertex', vertex: isVertexChosen ? selectedVertex : null })
    }
    const camera = theirs.camera()
    if (both.includes('camera') && camera) lookFrom(camera)
    if (both.includes('probe')) dispatch({ type: 'probe', point: probe })
    return both.length > 0
  }

  #now(): Known {
    const { vertices, preset, start, gestureStart, canUndo, canRedo, isVertexChosen, selectedVertex, probe } =
      this.#host.state()
    return {
      vertices: [vertices, preset, start, gestureStart, canUndo, canRedo, isVertexChosen, selectedVertex],
      camera: [this.#host.camera()],
      probe: [probe],
    }
  }
}
