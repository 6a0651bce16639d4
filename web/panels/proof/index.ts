import type { Panel } from '../panel'
import { certificateStyles, createCertificate } from './certificate'
import { proofQuestion, proofSlice } from './proof-question'

export const proof: Panel = {
  name: 'proof',
  region: 'panel',
  create: createCertificate,
  styles: certificateStyles,
  slice: proofSlice,
  question: proofQuestion,
}
