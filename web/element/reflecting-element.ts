/** Properties that are their attributes, and no more. */
import type { TellingElement } from './events'

/** A server has no elements; it only has to be able to import this. */
const Base = (globalThis.HTMLElement ?? class {}) as unknown as { new (): TellingElement; prototype: TellingElement }

export abstract class ReflectingElement extends Base {
  /** Reflects the attribute, as do the next eight. */
  declare views: string | null
  declare controls: string | null
  declare theme: string | null
  declare poster: string | null
  declare label: string | null
  declare group: string | null
  declare share: string | null
  declare app: string | null

  get readOnly(): boolean {
    return this.hasAttribute('readonly')
  }

  set readOnly(isReadonly: boolean) {
    this.toggleAttribute('readonly', Boolean(isReadonly))
  }
}

/** The text of an attribute for what a property is set to; null for none. Not everything has a text. */
export function textOf(given: unknown): string | null {
  if (given === null || given === undefined) return null
  try {
    return String(given)
  } catch {
    return typeof given
  }
}

/** Gives a class properties that are the attributes of the same names. */
export function reflectAttributes(prototype: HTMLElement, names: readonly string[]): void {
  for (const name of names)
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get(this: HTMLElement) {
        return this.getAttribute(name)
      },
      set(this: HTMLElement, given: unknown) {
        const text = textOf(given)
        if (text === null) this.removeAttribute(name)
        else this.setAttribute(name, text)
      },
    })
}

reflectAttributes(ReflectingElement.prototype, [
  'views',
  'controls',
  'theme',
  'poster',
  'label',
  'group',
  'share',
  'app',
])
