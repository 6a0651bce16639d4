/** Entries of Nastran bulk data put together from their lines, which may stand apart: mnemonics then say what belongs together. */
import type { PrintedDigits } from '../precision'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { addFields, Card, type LineLayout, plainMnemonic } from './nastran-card'
import type { TextLines } from './text-lines'

/** The values that are read of each entry. */
export const WANTED: Readonly<Record<string, number>> = wordTable({
  GRID: 5,
  GRDSET: 2,
  CHEXA: 23,
  CORD1R: 8,
  CORD1C: 8,
  CORD1S: 8,
  CORD2R: 11,
  CORD2C: 11,
  CORD2S: 11,
})

export class Cards {
  readonly #precision: PrintedDigits
  readonly #onCard: (card: Card) => void
  /** Null while an entry goes on that is of no interest. */
  #card: Card | null = null
  /** A card that is used again. */
  #spare: Card | null = null
  /** Entries whose next line has not come, and lines whose entry has not, by mnemonic. */
  readonly #waiting = new Map<string, Card>()
  readonly #orphans = new Map<string, Card>()

  /** `onCard` gets each entry when it is whole; `precision` sees the coordinates of GRID. */
  constructor(precision: PrintedDigits, onCard: (card: Card) => void) {
    this.#precision = precision
    this.#onCard = onCard
  }

  /** Begins an entry of interest with the line, which has been split. */
  begin(name: string, lines: TextLines, layout: LineLayout): void {
    const card = this.#spare ?? new Card(name)
    this.#spare = null
    card.reset(name, lines.number)
    this.#add(card, lines, layout)
  }

  /** Goes on with a line that has no name. */
  goOn(lines: TextLines, layout: LineLayout): void {
    const mnemonic = plainMnemonic(lines, 0)
    const waiting = mnemonic === '' ? undefined : this.#waiting.get(mnemonic)
    const isNext =
      this.#card !== null && (mnemonic === '' || this.#card.mnemonic === '' || mnemonic === this.#card.mnemonic)
    if (!isNext && waiting) {
      this.finish()
      this.#waiting.delete(mnemonic)
      this.#card = waiting
    } else if (!isNext && this.#card !== null) {
      const orphan = new Card(this.#card.name)
      orphan.line = lines.number
      addFields(orphan, lines, layout, WANTED.CHEXA as number, null)
      this.#orphans.set(mnemonic, orphan)
      return
    }
    this.#card?.fillUp()
    if (this.#card !== null) this.#add(this.#card, lines, layout)
  }

  /** A GRID is whole as soon as it has its values: others may go on. */
  #add(card: Card, lines: TextLines, layout: LineLayout): void {
    const isGrid = card.name === 'GRID'
    const wanted = WANTED[card.name] as number
    addFields(card, lines, layout, wanted, isGrid ? this.#precision : null)
    const isWhole = isGrid && card.count >= wanted
    this.#card = isWhole ? null : card
    if (isWhole) this.#hand(card)
  }

  #hand(card: Card): void {
    this.#onCard(card)
    this.#spare = card
  }

  /** The entry has no further lines, or they come later. */
  finish(): void {
    const card = this.#card
    this.#card = null
    if (card === null) return
    if (card.mnemonic === '') {
      this.#hand(card)
      return
    }
    const other = this.#waiting.get(card.mnemonic)
    if (other) this.#hand(other)
    this.#waiting.set(card.mnemonic, card)
  }

  /** Joins what stood apart, at the end of the file. */
  finishAll(lines: TextLines): void {
    this.finish()
    for (const card of this.#waiting.values()) {
      for (let next = this.#orphans.get(card.mnemonic); next; next = this.#orphans.get(card.mnemonic)) {
        this.#orphans.delete(card.mnemonic)
        card.fillUp()
        card.append(next)
      }
      this.#hand(card)
    }
    for (const [mnemonic, { line }] of this.#orphans)
      lines.refuse(`the continuation ${shown(mnemonic)} belongs to no entry.`, line)
  }
}
