/** The proof of the verdict, on request, to check without this page, and the file for a checker. */
import { html, render, type TemplateResult } from 'lit-html'
import { type Certificate, type CertifiedInterval, certificateJson } from '../../core/exact/certificate'
import { faces } from '../../model/hexahedron'
import { fractionText } from '../../model/rational'
import { type ReferenceCube, sliceChange, sliceOf } from '../../model/state'
import { copyText } from '../../views/copy-text'
import { isNew } from '../../views/is-new'
import { saveFile } from '../../views/save-file'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { type PlainWord, say, sayParts } from '../../words/say'
import { answerTo } from '../panel'
import css from './certificate.css?inline'
import { type Proof, proofQuestion, proofSlice } from './proof-question'
import { rationalText, roundedText } from './rational-text'
import { type Run, runsOf } from './runs'

export const certificateStyles = css

/** Runs of intervals shown of one face; the file has all. */
const SHOWN_RUNS = 8

type Invalid = Extract<Certificate, { valid: false }>
type Valid = Extract<Certificate, { valid: true }>

interface Reason {
  readonly formula: string
  readonly because: PlainWord
}

const REASONS: Readonly<Record<CertifiedInterval['by'], Reason>> = {
  b: { formula: 'b ≥ 0', because: 'in s jacdet rises or is concave, so it is nowhere below its lower end.' },
  '2a+b': { formula: '2a + b ≤ 0', because: 'in s jacdet falls or is concave, so it is nowhere below its lower end.' },
  middle: {
    formula: 'c + b/2 > 0',
    because: 'with c and a + b + c these are the Bernstein coefficients in s. All are positive.',
  },
  D: { formula: '4ac > b²', because: 'in s jacdet is a parabola that never reaches zero.' },
}

class CertificateView implements View {
  readonly root = document.createElement('section')
  readonly #context: ViewContext
  /** The last copy, and its proof; reported for as long as that proof is shown. */
  #copied: { readonly proof: Proof; readonly what: 'numbers' | 'json' | 'nothing' } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'certificate'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-label', say('Proof'))
  }

  update(frame: Frame): void {
    const { state, report } = frame
    const proof = answerTo(proofQuestion, frame)
    const { proofShown } = sliceOf(proofSlice, state)
    this.root.hidden = report === null
    const isStale = proof !== null && proof.vertices !== state.vertices
    if (isNew(this.root, proofShown, state.referenceCube, proof, isStale, this.#copied))
      render(this.#template(proofShown, state.referenceCube, proof, isStale), this.root)
  }

  dispose(): void {}

  #template(proofShown: boolean, cube: ReferenceCube, proof: Proof | null, isStale: boolean): TemplateResult {
    return html`<p class="bar">
        <button
          type="button"
          aria-expanded=${proofShown}
          aria-controls="proof"
          @click=${() => this.#context.dispatch(sliceChange(proofSlice, { proofShown: !proofShown }))}
        >
          ${proofShown ? say('Hide the proof') : say('Show the proof')}
        </button>
        <span aria-live="polite">${isStale ? say('The proof follows when this change is done.') : ''}</span>
      </p>
      <div id="proof" class=${isStale ? 'is-stale' : ''} ?hidden=${!proofShown}>${proof && this.#proof(proof, cube)}</div>`
  }

  #proof(proof: Proof, cube: ReferenceCube): TemplateResult {
    const { certificate } = proof
    const copied = this.#copied?.proof === proof ? this.#copied.what : null
    return html`${certificate.valid ? validProof(certificate) : invalidProof(certificate, cube)}
      <p class="actions">
        ${
          certificate.valid
            ? ''
            : html`<button type="button" @click=${() => this.#copy(proof, 'numbers', numbersText(certificate))}>
              ${copied === 'numbers' ? say('Copied') : say('Copy point and value')}
            </button>`
        }
        <button type="button" @click=${() => this.#copy(proof, 'json', this.#file(proof).text)}>
          ${copied === 'json' ? say('Copied') : say('Copy JSON')}
        </button>
        <button type="button" @click=${() => this.#download(proof)}>${say('Download')}</button>
        <span aria-live="polite">${copied === 'nothing' ? say('Copying is not allowed here. Download gives the same.') : ''}</span>
      </p>
      <p class="check">
        ${sayParts('To check it without this page: {check}. {certify} makes the same of a list of elements.', {
          check: html`<code>python3 tests/certificates/check_certificates.py FILE.json</code>`,
          certify: html`<code>npm run -s hexlens -- certify</code>`,
        })}
      </p>`
  }

  /** A list of one, as the command line prints it and the checker takes it. */
  #file({ vertices, certificate }: Proof): { readonly name: string; readonly text: string } {
    const { preset, start } = this.#context.state()
    const name = preset !== null && start === vertices ? preset : 'hexahedron'
    return { name, text: `[\n${JSON.stringify(certificateJson(name, vertices, certificate))}\n]\n` }
  }

  async #copy(proof: Proof, what: 'numbers' | 'json', text: string): Promise<void> {
    this.#copied = { proof, what: (await copyText(text)) ? what : 'nothing' }
    this.#context.requestFrame()
  }

  #download(proof: Proof): void {
    const { name, text } = this.#file(proof)
    saveFile(`${name}-certificate.json`, text, 'application/json')
  }
}

function invalidProof({ point, jacdet }: Invalid, cube: ReferenceCube): TemplateResult {
  const shown = cube === 'unit' ? jacdet : eighth(jacdet)
  const value = html`<span class=${jacdet.numerator < 0n ? 'number negative' : 'number'}>${rationalText(shown)}</span>${roundedText(shown)}`
  const place = html`(ξ, η, ζ) = <span class="number">(${point.map(rationalText).join(', ')})</span>`
  return html`<p>${
    jacdet.numerator < 0n
      ? sayParts('Proof: one point with J < 0. At {point} jacdet is exactly {value}.', { point: place, value })
      : sayParts('Proof: one point with J = 0. At {point} jacdet is exactly {value}.', { point: place, value })
  }</p>
    <p class="why">
      ${say('To check it, evaluate the definition once in rational numbers.')}
      ${cube === 'unit' ? '' : say('The file has it on [0,1]³, eight times this.')}
    </p>`
}

/** An eighth of a fraction, in lowest terms again. */
function eighth({ numerator, denominator }: Invalid['jacdet']): Invalid['jacdet'] {
  const common = [8n, 4n, 2n].find(factor => numerator % factor === 0n) ?? 1n
  return numerator === 0n
    ? { numerator, denominator }
    : { numerator: numerator / common, denominator: (denominator * 8n) / common }
}

/** "(1/2, 1, 1), -1/128": in full, for programs. */
function numbersText({ point, jacdet }: Invalid): string {
  return `(${point.map(fractionText).join(', ')}), ${fractionText(jacdet)}`
}

function validProof({ faces: intervals }: Valid): TemplateResult {
  const runs = intervals.map(runsOf)
  const used = (Object.keys(REASONS) as CertifiedInterval['by'][]).filter(by =>
    runs.some(list => list.some(run => run.by === by)),
  )
  const formula = (text: string) => html`<span class="formula">${text}</span>`
  return html`<p>${sayParts(
    'On a face jacdet is {formula}, with s and t in the order of ξ, η, ζ. On each interval of t it is positive at {lower} and {upper}. In between it is positive for the reason given.',
    { formula: formula('a(t) s² + b(t) s + c(t)'), lower: formula('s = 0'), upper: formula('s = 1') },
  )}</p>
    <table aria-label=${say('Intervals of each face')}>
      <thead>
        <tr><th scope="col">${say('face')}</th><th scope="col">${say('t from … to …')}</th><th scope="col">${say('intervals')}</th><th scope="col">${say('reason')}</th></tr>
      </thead>
      ${runs.map((list, face) => faceRows(list, face))}
    </table>
    <dl>
      ${used.map(by => html`<div><dt>${REASONS[by].formula}</dt><dd>${say(REASONS[by].because)}</dd></div>`)}
    </dl>
    <p class="why">
      ${sayParts(
        'Each sign is that of whole numbers, the Bernstein coefficients on the interval. If jacdet is positive on the six faces, it is positive everywhere: Knupp’s conjecture, now a theorem ({paper}).',
        { paper: html`P. Zhang, <cite lang="en">Validating Hexahedra through their Boundaries</cite>` },
      )}
    </p>`
}

function faceRows(runs: readonly Run[], face: number): TemplateResult {
  const shown = runs.slice(0, SHOWN_RUNS)
  const left = runs.slice(SHOWN_RUNS).reduce((sum, { count }) => sum + count, 0)
  const rowCount = shown.length + (left > 0 ? 1 : 0)
  return html`<tbody>
    ${shown.map(
      ({ from, to, count, by }, i) => html`<tr>
        ${i === 0 ? html`<th scope="rowgroup" rowspan=${rowCount}>${faces[face]?.name}</th>` : ''}
        <td>${say('{from} to {to}', { from: rationalText(from), to: rationalText(to) })}</td><td>${count}</td><td>${REASONS[by].formula}</td>
      </tr>`,
    )}
    ${left > 0 ? html`<tr><td colspan="3">${say('and {count} more, all in the file', { count: left })}</td></tr>` : ''}
  </tbody>`
}

export const createCertificate: CreateView = context => new CertificateView(context)
