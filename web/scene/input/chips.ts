/** For those who have no keys at hand: toggles that hold the next drags to an axis, to depth or to the grid. */
import { type DragKeys, FREE } from '../../views/scene-slices'
import { type PlainWord, say } from '../../words/say'

type Chip = {
  readonly [K in keyof DragKeys]: readonly [text: 'X' | 'Y' | 'Z' | PlainWord, key: K, value: DragKeys[K]]
}[keyof DragKeys]

const CHIPS: readonly Chip[] = [
  ['X', 'axis', 0],
  ['Y', 'axis', 1],
  ['Z', 'axis', 2],
  ['Depth', 'depth', true],
  ['Grid', 'snap', true],
]

export class Chips {
  readonly root = document.createElement('div')
  readonly #buttons: readonly HTMLButtonElement[]
  #held = FREE

  constructor(hold: (keys: DragKeys) => void) {
    this.root.className = 'chips'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-label', say('Drags are held to'))
    this.#buttons = CHIPS.map(([text, key, value]) => {
      const button = document.createElement('button')
      button.type = 'button'
      button.textContent = key === 'axis' ? text : say(text as PlainWord)
      button.addEventListener('click', () => {
        const { snap } = this.#held
        const isPressed = this.#held[key] === value
        // An axis and depth exclude each other; the grid goes with all of them.
        const others = key === 'snap' ? this.#held : { ...FREE, snap }
        hold({ ...others, [key]: isPressed ? FREE[key] : value })
      })
      return button
    })
    this.root.append(...this.#buttons)
  }

  update(held: DragKeys, isShown: boolean): void {
    this.#held = held
    this.root.hidden = !isShown
    this.#buttons.forEach((button, i) => {
      const [, key, value] = CHIPS[i] as Chip
      button.setAttribute('aria-pressed', String(held[key] === value))
    })
  }
}
