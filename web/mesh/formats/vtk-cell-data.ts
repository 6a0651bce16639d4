/** Arrays of cells in VTK's files that are ids, or put the cells into blocks: known by the names that programs give them. */

/** The arrays of all cells of a grid. */
export interface CellData {
  /** Whole numbers, all different. */
  readonly ids: Float64Array | null
  readonly blocks: { readonly name: string; readonly values: Float64Array } | null
}

const IDS =
  /^(?:vtk|global|pedigree|original)?(?:cell|elem|element)(?:global)?(?:ids?|gids?|nos?|nr|numbers?|labels?)$|^(?:vtk)?(?:global|pedigree)ids?$|^eids?$/
/** The most telling first. */
const BLOCKS: readonly RegExp[] = [
  /^gmshphysical$|^physical(?:group)?(?:ids?|tags?)?$/,
  /^(?:material|mat|property|prop|section|attribute|meditref)(?:ids?|nos?|nr|numbers?|index|tags?|markers?)?$|^[pm]ids?$/,
  /^(?:elementblock|elemblock|block|cellentity|region|zone|group|part|component)(?:ids?|nos?|nr|numbers?|index|tags?|markers?)?$/,
  /^(?:subdomain|domain|object)(?:ids?|nos?|index|tags?|markers?)?$|^gmshgeometrical$|^(?:cell)?(?:tags?|markers?)$/,
]
const MOST_BLOCKS = 10_000

/** The rank of a name: 0 for ids, then blocks; -1 for arrays that need not be read. */
export function cellDataRank(name: string): number {
  const plain = name.toLowerCase().replace(/[^a-z]/g, '')
  return IDS.test(plain) ? 0 : BLOCKS.findIndex(pattern => pattern.test(plain)) + 1 || -1
}

/** Ids and blocks from arrays of a number each; `globalIds` is what the file calls so. */
export function cellDataOf(arrays: ReadonlyMap<string, Float64Array>, globalIds: string | null): CellData | null {
  const ranked = [...arrays].map(([name, values]) => ({ name, values, rank: cellDataRank(name) }))
  const candidates = ranked.filter(({ name, rank }) => name === globalIds || rank === 0)
  const ids = [...candidates].sort((a, b) => Number(b.name === globalIds) - Number(a.name === globalIds))
  const blocks = ranked.filter(({ name, rank }) => name !== globalIds && rank > 0).sort((a, b) => a.rank - b.rank)
  const data = {
    ids: ids.find(({ values }) => areIds(values))?.values ?? null,
    blocks: blocks.find(({ values }) => areBlocks(values)) ?? null,
  }
  return data.ids === null && data.blocks === null ? null : data
}

function areIds(values: Float64Array): boolean {
  const seen = new Set<number>()
  for (const value of values) seen.add(Number.isSafeInteger(value) ? value : Number.NaN)
  return seen.size === values.length && !seen.has(Number.NaN)
}

function areBlocks(values: Float64Array): boolean {
  const seen = new Set<number>()
  for (const value of values) {
    if (!Number.isSafeInteger(value)) return false
    seen.add(value)
    if (seen.size > MOST_BLOCKS) return false
  }
  return seen.size > 0
}
