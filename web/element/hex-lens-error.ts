import type { HistoryErrorCode } from '../model/history-document'
import type { StateErrorCode } from '../model/state-document'

/** The reason why an element refused its input: `code` for programs, `message` for people. */
export type HexLensErrorCode =
  | 'wrong-count'
  | 'not-finite'
  | 'bad-attribute'
  | 'bad-argument'
  | 'no-core'
  | 'no-picture'
  | HistoryErrorCode
  | StateErrorCode

export class HexLensError extends TypeError {
  override readonly name = 'HexLensError'
  readonly code: HexLensErrorCode

  constructor(code: HexLensErrorCode, message: string) {
    super(message)
    this.code = code
  }
}
