/** The text and the pictures of a PDF as Chromium writes it: plain objects, deflated streams, glyphs named by a ToUnicode map. */
import { inflateSync } from 'node:zlib'

export interface PdfContents {
  /** The text of each page. */
  readonly pages: readonly string[]
  /** Width and height in pixels. */
  readonly pictures: readonly (readonly [number, number])[]
}

export function readPdf(file: Buffer): PdfContents {
  const objects = new Map<number, string>()
  for (const [, number, body] of file.toString('latin1').matchAll(/(\d+) 0 obj\s(.*?)endobj/gs))
    objects.set(Number(number), body as string)
  const bodies = [...objects.values()]
  const glyphs = new Map<string, ReadonlyMap<string, string>>()
  for (const [number, body] of objects) {
    const map = /\/ToUnicode (\d+) 0 R/.exec(body)
    if (map) glyphs.set(`F${number}`, glyphMap(streamOf(objects.get(Number(map[1])) ?? '')))
  }
  const contents = bodies.flatMap(body => /\/Type\s*\/Page\b.*?\/Contents (\d+) 0 R/s.exec(body)?.[1] ?? [])
  return {
    pages: contents.map(number => textOf(streamOf(objects.get(Number(number)) ?? ''), glyphs)),
    pictures: bodies
      .filter(body => /\/Subtype\s*\/Image/.test(body))
      .map(body => [Number(/\/Width (\d+)/.exec(body)?.[1]), Number(/\/Height (\d+)/.exec(body)?.[1])] as const),
  }
}

function streamOf(body: string): string {
  const begin = /stream\r?\n/.exec(body)
  if (begin === null) return ''
  // The last byte of a compressed stream may look like an end of line.
  const from = begin.index + begin[0].length
  const bytes = body.slice(from, from + Number(/\/Length (\d+)/.exec(body)?.[1]))
  const raw = Buffer.from(bytes, 'latin1')
  return body.includes('/FlateDecode') ? inflateSync(raw).toString('latin1') : bytes
}

/** Glyph, as four hexadecimal digits, to what it stands for. */
function glyphMap(map: string): ReadonlyMap<string, string> {
  const found = new Map<string, string>()
  const hex = (value: number) => value.toString(16).toUpperCase().padStart(4, '0')
  const letters = (code: string) => Buffer.from(code, 'hex').swap16().toString('utf16le')
  for (const [, block] of map.matchAll(/beginbfchar(.*?)endbfchar/gs))
    for (const [, glyph, code] of (block as string).matchAll(/<(\w{4})> <(\w+)>/g))
      found.set((glyph as string).toUpperCase(), letters(code as string))
  for (const [, block] of map.matchAll(/beginbfrange(.*?)endbfrange/gs))
    for (const [, first, last, code] of (block as string).matchAll(/<(\w{4})> <(\w{4})> <(\w{4})>/g)) {
      const from = Number.parseInt(first as string, 16)
      for (let glyph = from; glyph <= Number.parseInt(last as string, 16); glyph++)
        found.set(hex(glyph), String.fromCharCode(Number.parseInt(code as string, 16) + glyph - from))
    }
  return found
}

function textOf(stream: string, glyphs: ReadonlyMap<string, ReadonlyMap<string, string>>): string {
  let font: ReadonlyMap<string, string> | undefined
  let text = ''
  for (const [, name, shown] of stream.matchAll(/\/(F\d+) [\d.]+ Tf|<([\dA-Fa-f]+)>(?=[^\]]*(?:Tj|TJ))/g)) {
    if (name !== undefined) font = glyphs.get(name)
    else text += (shown?.match(/\w{4}/g) ?? []).map(glyph => font?.get(glyph.toUpperCase()) ?? '').join('')
  }
  return text
}
