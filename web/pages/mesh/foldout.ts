/** A button on top of the page Mesh, and what it shows below: one of these at a time, since they move the picture down. Escape closes it. */

let opened: Foldout | null = null

export class Foldout {
  readonly button = document.createElement('button')
  readonly root = document.createElement('section')

  constructor(id: string, name: string) {
    this.button.type = 'button'
    this.button.textContent = name
    this.button.setAttribute('aria-controls', id)
    this.button.addEventListener('click', () => {
      this.isOpen = !this.isOpen
    })
    this.root.className = id
    this.root.id = id
    this.root.setAttribute('aria-label', name)
    for (const part of [this.button, this.root])
      part.addEventListener('keydown', ({ key }) => {
        if (key !== 'Escape' || !this.isOpen) return
        this.isOpen = false
        this.button.focus()
      })
    this.isOpen = false
  }

  get isOpen(): boolean {
    return !this.root.hidden
  }

  set isOpen(isOpen: boolean) {
    if (isOpen && opened !== this) {
      if (opened) opened.isOpen = false
      opened = this
    }
    this.root.hidden = !isOpen
    this.button.setAttribute('aria-expanded', String(isOpen))
  }
}
