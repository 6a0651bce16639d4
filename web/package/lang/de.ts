/** German for the element: a script of its own, for pages and bundlers alike. */
import { german } from '../../words/de'
import { addLanguage } from '../../words/say'

addLanguage('de', german)
