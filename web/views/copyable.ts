/** Numbers as read, with all digits to copy: `copying.ts` listens for a press of any of them. */
import { html, type TemplateResult } from 'lit-html'
import { formatJacdet, formatPoint, jacdetInFull } from '../model/decimal'
import type { Vec3 } from '../model/hexahedron'
import type { ReferenceCube } from '../model/state'
import { say } from '../words/say'

export interface CopyableOptions {
  /** False for all numbers of a table but the first; arrow keys go from one to the next. */
  readonly isTabStop?: boolean
  /** The tooltip says this besides the digits. */
  readonly means?: string
}

/** `full` is the text for programs. */
export function copyable(
  text: string,
  full: string,
  { isTabStop = true, means }: CopyableOptions = {},
): TemplateResult {
  const title =
    means === undefined ? say('Copy {text}', { text: full }) : say('Copy {text}. {means}', { text: full, means })
  return html`<data role="button" tabindex=${isTabStop ? 0 : -1} value=${full} title=${title}>${text}</data>`
}

/** A report's jacdet, value * 2^exponent; a negative one has its hue in prose, too. */
export function copyableJacdet(
  value: number,
  exponent: number,
  cube: ReferenceCube,
  options?: CopyableOptions,
): TemplateResult {
  const number = copyable(formatJacdet(value, exponent, cube), jacdetInFull(value, exponent, cube), options)
  return value < 0 ? html`<span class="negative">${number}</span>` : number
}

export function copyablePoint(point: Vec3): TemplateResult {
  return copyable(formatPoint(point), point.join(', '))
}
