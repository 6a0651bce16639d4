/** Chinese for the element: a script of its own, for pages and bundlers alike. */

import { addLanguage } from '../../words/say'
import { chinese } from '../../words/zh'

addLanguage('zh', chinese)
