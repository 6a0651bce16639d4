const decoder = new TextDecoder('latin1')

/** The first bytes of a file as text, in which formats look for their words. */
export function headText(head: Uint8Array): string {
  return decoder.decode(head)
}
