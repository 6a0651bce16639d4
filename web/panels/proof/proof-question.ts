/** The panel's slice, true if the proof is shown, and its question: the certificate. */
import { type Certificate, certificateOf } from '../../core/exact/certificate'
import { described, flag } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { type Slice, sliceOf } from '../../model/state'
import type { Question } from '../panel'

/** A certificate and its element: while a gesture runs, the one before it. */
export interface Proof {
  readonly vertices: Vertices
  readonly certificate: Certificate
}

export const proofSlice: Slice<{ readonly proofShown: boolean }> = {
  name: 'proof',
  first: { proofShown: false },
  readers: { proofShown: described('Whether the proof of the verdict is open.', flag) },
}

export const proofQuestion: Question<Proof> = {
  name: 'proof',
  start() {
    let proof: Proof | null = null
    return {
      answer(core, state) {
        const { vertices, gestureStart } = state
        if (!sliceOf(proofSlice, state).proofShown) proof = null
        else if (proof?.vertices !== vertices && (proof === null || gestureStart === null)) {
          const result = certificateOf(core, vertices)
          proof = result.ok ? { vertices, certificate: result.value } : null
        }
        return proof
      },
    }
  },
}
