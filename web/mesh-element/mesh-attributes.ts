/** The attributes of `<hex-mesh>`, and the sentences that refuse others' values. */
import { oneOf, THEMES } from '../element/attributes'

/** The cells that are drawn: all, the invalid ones, or these with the cells that share a point with them. */
export const MODES = ['surface', 'invalid', 'neighbours'] as const
export type Mode = (typeof MODES)[number]

export const MESH_ATTRIBUTES = ['src', 'mode', 'theme', 'label'] as const
export type MeshAttribute = (typeof MESH_ATTRIBUTES)[number]

/** Throws HexLensError. */
export function readMode(text: string | null): Mode {
  return oneOf('mode', text ?? 'surface', MODES)
}

/** Throws HexLensError. The style sheet does what it says. */
export function readTheme(text: string | null): (typeof THEMES)[number] {
  return oneOf('theme', text ?? 'auto', THEMES)
}

/** The text or the files that a program gives to be opened; null if it is neither. */
export function inputOf(given: unknown): { readonly text: string } | { readonly files: readonly File[] } | null {
  if (typeof given === 'string') return { text: given }
  const files = given instanceof File ? [given] : Array.from((given as Iterable<unknown> | null) ?? [])
  return files.length > 0 && files.every(file => file instanceof File) ? { files: files as File[] } : null
}
