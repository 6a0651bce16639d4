/** A pointer on the picture of a mesh, which also turns it: what it clicks, and what it rests on. */

export interface CellPointerHost {
  click(event: PointerEvent): void
  /** Once a frame, of a mouse with no button pressed; null once it has left. */
  point(event: PointerEvent | null): void
}

/** CSS pixels: a pointer that has moved less has clicked. */
const CLICK = 4

export class CellPointer {
  #frame = 0

  constructor(root: HTMLElement, host: CellPointerHost) {
    let down: { readonly x: number; readonly y: number } | null = null
    root.addEventListener('pointerdown', ({ clientX: x, clientY: y, button }) => {
      down = button === 0 ? { x, y } : null
    })
    root.addEventListener('pointercancel', () => {
      down = null
    })
    root.addEventListener('pointerup', event => {
      const isClick = down !== null && Math.hypot(event.clientX - down.x, event.clientY - down.y) < CLICK
      down = null
      if (isClick) host.click(event)
    })
    root.addEventListener('pointermove', event => {
      if (event.pointerType !== 'mouse' || event.buttons !== 0) return
      this.end()
      this.#frame = requestAnimationFrame(() => host.point(event))
    })
    root.addEventListener('pointerleave', () => {
      this.end()
      host.point(null)
    })
  }

  /** Forgets a move that was to be told of. */
  end(): void {
    cancelAnimationFrame(this.#frame)
  }
}
