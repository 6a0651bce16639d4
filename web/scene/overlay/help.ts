/** The effects of hands and keys in the scene: its description for those who hear the page, and on request for everybody. */

/** An action and its effect, which make a sentence. */
const HELP: readonly (readonly [string, string])[] = [
  ['Drag a handle', 'moves its vertex. Shift moves it in depth, Alt on a grid, X, Y or Z along that axis alone'],
  ['Drag elsewhere', 'turns the view. Two fingers, or Ctrl and the wheel, zoom'],
  ['0 to 7, or [ and ]', 'choose a vertex'],
  ['Arrow keys', 'move the chosen vertex along the axis that is nearest to the arrow'],
  ['Page Up, Page Down', 'move it along the third axis'],
  ['Shift, Alt', 'with these keys make the step ten times as long, or a tenth'],
  ['Point at a face', 'or tap it, to read jacdet at that point: the probe'],
  ['P', 'puts the probe on the next candidate; C copies its numbers'],
  ['M', 'turns the view to the minimum, or shows it through the faces'],
  ['Escape', 'puts a vertex that is being moved back; at other times it removes the probe'],
  ['A, D, W, S', 'turn the view; plus and minus zoom, F fits it, Home resets it'],
  ['T, I', 'make faces see-through, or show the inside; comma and full stop show one face alone'],
  ['R, ?', 'show and hide the reference cube, or this help'],
]

export class Help {
  readonly root = document.createElement('dl')

  constructor(id: string) {
    this.root.id = id
    this.root.className = 'scene-help'
    this.root.hidden = true
    this.root.tabIndex = 0 // it scrolls in a small scene
    for (const [keys, effect] of HELP) this.root.append(entry(keys, effect))
  }

  show(isShown: boolean): void {
    this.root.hidden = !isShown
  }
}

function entry(keys: string, effect: string): HTMLElement {
  const [line, term, detail] = ['div', 'dt', 'dd'].map(name => document.createElement(name)) as [
    HTMLElement,
    HTMLElement,
    HTMLElement,
  ]
  term.textContent = keys
  detail.textContent = `${effect}.`
  line.append(term, ' ', detail, ' ')
  return line
}
