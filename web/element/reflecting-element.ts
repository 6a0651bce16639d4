/** Properties that are their attributes, and no more. */

/** A server has no elements; it only has to be able to import this. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement)

export abstract class ReflectingElement extends Base {
  get views(): string | null {
    return this.getAttribute('views')
  }

  set views(text: string | null) {
    this.#reflect('views', text)
  }

  get controls(): string | null {
    return this.getAttribute('controls')
  }

  set controls(text: string | null) {
    this.#reflect('controls', text)
  }

  get camera(): string | null {
    return this.getAttribute('camera')
  }

  set camera(text: string | null) {
    this.#reflect('camera', text)
  }

  get theme(): string | null {
    return this.getAttribute('theme')
  }

  set theme(text: string | null) {
    this.#reflect('theme', text)
  }

  get poster(): string | null {
    return this.getAttribute('poster')
  }

  set poster(text: string | null) {
    this.#reflect('poster', text)
  }

  get label(): string | null {
    return this.getAttribute('label')
  }

  set label(text: string | null) {
    this.#reflect('label', text)
  }

  get readOnly(): boolean {
    return this.hasAttribute('readonly')
  }

  set readOnly(isReadonly: boolean) {
    this.toggleAttribute('readonly', isReadonly)
  }

  #reflect(name: string, text: string | null | undefined): void {
    if (text === null || text === undefined) this.removeAttribute(name)
    else this.setAttribute(name, text)
  }
}
