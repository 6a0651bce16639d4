/** What a search has found after so many blocks of its stream: enough to go on from there, in another page too. */
import type { Query } from './query'
import { type Find, type Order, Ranking } from './ranking'
import { BLOCK, type PieceFinds } from './search-piece'

/** A tally as JSON. */
export interface TallyDocument {
  readonly query: Query
  readonly blocks: number
  readonly found: number
  /** The best in either order. */
  readonly finds: readonly Find[]
}

export class Tally {
  readonly query: Query
  readonly #rankings: Readonly<Record<Order, Ranking>> = {
    simplicity: new Ranking('simplicity'),
    extremeness: new Ranking('extremeness'),
  }
  #blocks = 0
  #found = 0

  constructor(query: Query) {
    this.query = query
  }

  static from({ query, blocks, found, finds }: TallyDocument): Tally {
    const tally = new Tally(query)
    tally.#add(blocks, found, finds)
    return tally
  }

  /** Blocks taken in, all of the stream up to there. */
  get blocks(): number {
    return this.#blocks
  }

  get elements(): number {
    return this.#blocks * BLOCK
  }

  /** Elements that have the property. */
  get found(): number {
    return this.#found
  }

  finds(order: Order): readonly Find[] {
    return this.#rankings[order].finds
  }

  /** Takes in the next piece of the stream. */
  take({ piece, found, finds }: Pick<PieceFinds, 'piece' | 'found' | 'finds'>): void {
    this.#add(piece.blocks, found, finds)
  }

  get document(): TallyDocument {
    const finds = Object.values(this.#rankings).flatMap(ranking => ranking.finds)
    const byIndex = new Map(finds.map(find => [find.index, find]))
    return { query: this.query, blocks: this.#blocks, found: this.#found, finds: [...byIndex.values()] }
  }

  #add(blocks: number, found: number, finds: readonly Find[]): void {
    this.#blocks += blocks
    this.#found += found
    for (const ranking of Object.values(this.#rankings)) for (const find of finds) ranking.add(find)
  }
}
