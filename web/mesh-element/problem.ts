/** A reason why there is no mesh: `code` for programs, and a sentence for people, to be said in the element's language. */
export class MeshProblem extends Error {
  readonly code: 'not-fetched' | 'too-large' | 'not-read'
  readonly sentence: () => string

  constructor(code: MeshProblem['code'], sentence: () => string) {
    super(code)
    this.code = code
    this.sentence = sentence
  }
}
