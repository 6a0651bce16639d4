/** What the picture draws, and what it draws next: faces are loaded bit by bit, frame after frame, and then take the place of those before. */
import type { FaceList } from '../survey/survey-jobs'
import { CHUNK_FACES, FACES_AT_ONCE, FaceChunks } from './face-chunks'

export interface Content {
  /** The boundary of the mesh, as far as `hidden` leaves it; null if `surface` has all that is to be seen. */
  readonly boundary: FaceList | null
  /** 1 for each vertex of the boundary whose face is not there; null hides none. */
  readonly hidden: Uint8Array | null
  readonly surface: FaceList | null
  readonly invalid: FaceList | null
  /** 1 hides what is behind the surface. */
  readonly opacity: number
  /** Cells that are drawn whole are drawn with this part of their size. */
  readonly size: number
  /** The whole boundary as a shadow of what the picture is cut from. */
  readonly hasGhost: boolean
}

/** The opacity of a surface through which invalid cells are seen. */
export const TRANSLUCENT = 0.28

/** Cells inside of which all faces are drawn: more would be a second of drawing on a slow machine, and what is left out is said. */
export const MOST_WHOLE = 20_000

export const NO_CONTENT: Content = {
  boundary: null,
  hidden: null,
  surface: null,
  invalid: null,
  opacity: 1,
  size: 1,
  hasGhost: false,
}

const LISTS = ['boundary', 'surface', 'invalid'] as const
type ListName = (typeof LISTS)[number]
export type Lists = Readonly<Record<ListName, FaceChunks | null>>

const NO_LISTS: Lists = { boundary: null, surface: null, invalid: null }

export class LoadedFaces {
  #content = NO_CONTENT
  #lists = NO_LISTS
  #next: { readonly content: Content; readonly lists: Lists } | null = null

  /** As it is drawn. */
  get content(): Content {
    return this.#content
  }

  get lists(): Lists {
    return this.#lists
  }

  /** True until `load` has loaded all that was put. */
  get isLoading(): boolean {
    return this.#next !== null
  }

  /** Lists that are the same as before are not loaded again. */
  put(content: Content, gl: WebGL2RenderingContext): void {
    const before = this.#next?.lists ?? NO_LISTS
    const own = (name: ListName) => {
      const faces = content[name]
      if (!faces) return null
      const known = [this.#lists[name], before[name]].find(list => list?.faces === faces)
      return known ?? new FaceChunks(faces)
    }
    const lists = { boundary: own('boundary'), surface: own('surface'), invalid: own('invalid') }
    this.#giveUp(before, [lists, this.#lists], gl)
    this.#next = { content, lists }
  }

  /** Goes on, once in a frame. True if there is something else to draw from now on. */
  load(gl: WebGL2RenderingContext): boolean {
    if (!this.#next) return false
    const { content, lists } = this.#next
    let left = FACES_AT_ONCE
    for (const name of LISTS)
      for (const list = lists[name]; list && !list.isLoaded; left -= CHUNK_FACES) {
        if (left <= 0) return false
        list.load(gl)
      }
    lists.boundary?.hide(gl, content.hidden)
    const before = this.#lists
    this.#content = content
    this.#lists = lists
    this.#next = null
    this.#giveUp(before, [lists], gl)
    return true
  }

  /** Finds where some of the faces are. False if it is known of all that are drawn. */
  find(): boolean {
    return LISTS.some(name => this.#lists[name]?.find())
  }

  /** All of it again, for a context that has lost it. */
  renew(gl: WebGL2RenderingContext): void {
    const content = this.#next?.content ?? this.#content
    this.clear(gl)
    this.put(content, gl)
  }

  clear(gl: WebGL2RenderingContext): void {
    for (const lists of [this.#lists, this.#next?.lists ?? NO_LISTS]) this.#giveUp(lists, [], gl)
    this.#content = NO_CONTENT
    this.#lists = NO_LISTS
    this.#next = null
  }

  #giveUp(lists: Lists, kept: readonly Lists[], gl: WebGL2RenderingContext): void {
    for (const name of LISTS)
      if (lists[name] && !kept.some(other => other[name] === lists[name])) lists[name].dispose(gl)
  }
}
