/**
 * A table of words that stand in files. It knows no others: every object of JavaScript has a “constructor” and a “__proto__”,
 * and a file may have such words as well.
 */
export function wordTable<T extends object>(meanings: T): T {
  return Object.assign(Object.create(null), meanings)
}
