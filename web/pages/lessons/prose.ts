/** The lessons' HTML as a template. */
import { unsafeHTML } from 'lit-html/directives/unsafe-html.js'
import { withTerms } from './glossary'

/** No line begins with the punctuation after a formula; words of the glossary can be pointed at. */
export function prose(text: string): ReturnType<typeof unsafeHTML> {
  return unsafeHTML(
    withTerms(text).replace(/<math>(?:(?!<\/math>).)*<\/math>[.,;:)]+/gs, '<span class="together">$&</span>'),
  )
}
