/** The effects of fingers, mouse and keys in the scene: its description for those who hear the page, and on request for everybody. */
import type { ControlsState } from '../../views/scene-slices'
import { type PlainWord, say } from '../../words/say'

/** An action and its effect, which make a sentence. */
type Entry = readonly [action: PlainWord, effect: PlainWord]

const FOR_FINGERS: readonly Entry[] = [
  ['Drag a handle', 'moves its vertex. X, Y, Z, Depth and Grid, there once a vertex is chosen, hold the next drags'],
  ['Drag elsewhere', 'turns the view if you begin sideways; up and down scrolls the page'],
  ['Two fingers', 'zoom and shift the view; Fit brings the element back'],
  ['Tap a face', 'to read jacdet there: the probe. The box is the image of a little cube, enlarged'],
  ['Tap beside the element', 'to remove the probe and let go of the vertex'],
  ['Turn', 'turns and zooms the view by buttons'],
  ['All faces', 'makes faces see-through, or shows one alone'],
]

const FOR_KEYS: readonly Entry[] = [
  ['Drag a handle', 'moves its vertex. Shift moves it in depth, Alt on a grid, X, Y or Z along that axis alone'],
  ['Drag elsewhere', 'turns the view. Two fingers, or Ctrl and the wheel, zoom'],
  ['0 to 7, or [ and ]', 'choose a vertex'],
  ['Arrow keys', 'move the chosen vertex along the axis that is nearest to the arrow'],
  ['Page Up, Page Down', 'move it along the third axis'],
  [
    'Shift, Ctrl',
    'with arrow keys make the step ten times as long, or a tenth. On a Mac, and with Page Up and Down, it is Alt',
  ],
  ['Point at a face', 'or tap it, to read jacdet there: the probe. The box is the image of a little cube, enlarged'],
  ['P', 'puts the probe on the next candidate; C copies its numbers'],
  ['M', 'turns the view to the minimum, or shows it through the faces'],
  ['Escape', 'puts a vertex that is being moved back; at other times it removes the probe'],
  ['A, D, W, S', 'turn the view; plus and minus zoom, F fits it, Home resets it'],
  ['T, I', 'make faces see-through, or show the inside; comma and full stop show one face alone'],
  ['R, ?', 'show and hide the reference cube, or this help'],
]

export class Help {
  readonly root = document.createElement('dl')
  #isForFingers: boolean | null = null

  constructor(id: string) {
    this.root.id = id
    this.root.className = 'scene-help'
    this.root.hidden = true
    this.root.tabIndex = 0 // it scrolls in a small scene
  }

  update({ helpShown, byFinger }: Pick<ControlsState, 'helpShown' | 'byFinger'>): void {
    this.root.hidden = !helpShown
    if (byFinger === this.#isForFingers) return
    this.#isForFingers = byFinger
    this.root.replaceChildren(...(byFinger ? FOR_FINGERS : FOR_KEYS).map(entry))
  }
}

function entry([action, effect]: Entry): HTMLElement {
  const [line, term, detail] = ['div', 'dt', 'dd'].map(name => document.createElement(name)) as [
    HTMLElement,
    HTMLElement,
    HTMLElement,
  ]
  term.textContent = say(action)
  detail.textContent = say('{sentence}.', { sentence: say(effect) })
  line.append(term, ' ', detail, ' ')
  return line
}
