/** The author's choice in Copy embed. */
import { between, described, flag, oneOf, orNull, record, text, texts } from '../../model/document-readers'
import type { Slice } from '../../model/state'
import { type Embed, THEMES } from './embed-lines'

export interface Choice extends Pick<Embed, 'views' | 'theme' | 'readonly' | 'camera' | 'height'> {
  /** Its id; one that is not known means the first. */
  readonly host: string
  /** Null if it is to be the one that follows from the verdict. */
  readonly label: string | null
}

export const HEIGHTS = { least: 160, most: 4000, isWhole: true } as const

const FIRST: Choice = {
  host: '',
  views: ['scene', 'verdict'],
  theme: 'auto',
  readonly: false,
  camera: null,
  height: 480,
  label: null,
}

export const choiceSlice: Slice<{ readonly embedding: Choice }> = {
  name: 'embed',
  first: { embedding: FIRST },
  readers: {
    embedding: described(
      'What is chosen in Copy embed.',
      record<Choice>(
        {
          host: text,
          views: texts,
          theme: oneOf(...THEMES),
          readonly: flag,
          camera: orNull(text),
          height: between(HEIGHTS.least, HEIGHTS.most),
          label: orNull(text),
        },
        FIRST,
      ),
    ),
  },
}
