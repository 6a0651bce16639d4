/** The effects of hands and keys in the scene: its description for those who hear the page, and on request for everybody. */

/** An action and its effect, which make a sentence. */
const HELP: readonly (readonly [string, string])[] = [
  ['Drag a handle', 'moves its vertex. With Shift in depth, with Alt on a grid, with X, Y or Z held along that axis'],
  ['Drag elsewhere', 'turns the view. Ctrl and the wheel, or two fingers, zoom'],
  ['0 to 7, or [ and ]', 'choose a vertex'],
  ['Arrow keys', 'move it along the nearest coordinate axis'],
  ['Page Up, Page Down', 'move it along the third axis'],
  ['Shift, Alt', 'with these keys: ten times as far, a tenth'],
  ['Point at a face', 'or tap it, to read the Jacobian there'],
  ['P', 'goes through the candidates; C copies the point'],
  ['Escape', 'takes back the move while a key or the pointer is held, else the point'],
  ['A, D, W, S', 'turn the view; plus and minus zoom, F fits, Home resets it'],
  ['T, I', 'make faces see-through, show what is inside; comma and dot show one face'],
  ['R, ?', 'show and hide the reference cube, this help'],
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
