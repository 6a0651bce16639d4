/** A section that its button shows and hides; Escape in it hides it. Both are hidden at first. */
export class ButtonSection {
  readonly button = document.createElement('button')
  readonly root = document.createElement('section')

  constructor(id: string, name: string) {
    const { button, root } = this
    button.type = 'button'
    button.textContent = name
    button.hidden = true
    button.setAttribute('aria-controls', id)
    button.addEventListener('click', () => this.open(Boolean(root.hidden)))
    root.id = id
    root.className = id
    root.setAttribute('aria-label', name)
    root.addEventListener('keydown', event => {
      if (event.key !== 'Escape') return
      this.open(false)
      button.focus()
    })
    this.open(false)
  }

  open(isOpen: boolean): void {
    this.root.hidden = !isOpen
    this.button.setAttribute('aria-expanded', String(isOpen))
  }
}
