/** Results of readers at a boundary, and the error they throw on the way there. */

/** A value, or why there is none. */
export type Result<Value, Problem> =
  | { readonly ok: true; readonly value: Value }
  | { readonly ok: false; readonly error: Problem }

export interface CodedError<Code extends string> {
  readonly code: Code
  /** One sentence for people. */
  readonly message: string
}

export function refused<const Code extends string>(
  code: Code,
  message: string,
): { readonly ok: false; readonly error: CodedError<Code> } {
  return { ok: false, error: { code, message } }
}

/** The message is one sentence for people: what was found where, and what was expected. */
export class Refusal extends Error {}
