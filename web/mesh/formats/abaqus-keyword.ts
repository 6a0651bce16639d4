/** A keyword line of Abaqus: "*Element, type=C3D8R, elset=hex". */

export interface Keyword {
  /** The keyword in capitals, without the star and blanks: "ENDPART". */
  readonly name: string
  /** The keyword as the file writes it, for people. */
  readonly written: string
  /** Values by parameter in capitals without blanks; '' for a parameter without a value. */
  readonly parameters: ReadonlyMap<string, string>
}

export function keywordOf(line: string): Keyword {
  const [first = '', ...rest] = splitOutsideQuotes(line)
  const written = first.trim()
  const parameters = new Map<string, string>()
  for (const parameter of rest) {
    const equals = parameter.indexOf('=')
    const name = withoutBlanks(equals < 0 ? parameter : parameter.slice(0, equals))
    if (name !== '') parameters.set(name, equals < 0 ? '' : unquoted(parameter.slice(equals + 1)))
  }
  return { name: withoutBlanks(written.slice(1)), written, parameters }
}

function splitOutsideQuotes(line: string): string[] {
  const parts: string[] = []
  let begin = 0
  let quote = ''
  for (let i = 0; i < line.length; ++i) {
    const letter = line[i] as string
    if (quote !== '') {
      if (letter === quote) quote = ''
    } else if (letter === '"' || letter === "'") quote = letter
    else if (letter === ',') {
      parts.push(line.slice(begin, i))
      begin = i + 1
    }
  }
  parts.push(line.slice(begin))
  return parts
}

function withoutBlanks(word: string): string {
  return word.replace(/\s/g, '').toUpperCase()
}

export function unquoted(word: string): string {
  const plain = word.trim()
  const quote = plain[0]
  return plain.length >= 2 && (quote === '"' || quote === "'") && plain.endsWith(quote) ? plain.slice(1, -1) : plain
}
