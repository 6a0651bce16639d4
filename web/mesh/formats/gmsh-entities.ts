/** $Entities and $PartitionedEntities of MSH 4: which physical groups an entity is in. Text and binary are the same numbers. */
import type { Version } from './gmsh-binary'
import type { GmshMesh } from './gmsh-mesh'

/** The numbers of a section, one after the other. */
export interface Numbers {
  int(): number
  /** An integer that is not negative, of the size of a size_t. */
  size(): number
  double(): void
}

export function readEntities(numbers: Numbers, mesh: GmshMesh, version: Version, isPartitioned: boolean): void {
  const times = (count: number, read: () => void) => {
    for (let i = 0; i < count; ++i) read()
  }
  if (isPartitioned) {
    numbers.size()
    times(numbers.size(), () => {
      numbers.int()
      numbers.int()
    })
  }
  const counts = [numbers.size(), numbers.size(), numbers.size(), numbers.size()]
  for (const [dimension, count] of counts.entries()) {
    times(count, () => {
      const tag = numbers.int()
      if (isPartitioned) {
        numbers.int()
        numbers.int()
        times(numbers.size(), () => numbers.int())
      }
      times(dimension === 0 && version === 4.1 ? 3 : 6, () => numbers.double())
      const groups: number[] = []
      times(numbers.size(), () => groups.push(numbers.int()))
      mesh.groupsOfEntity(dimension, tag, groups)
      if (dimension > 0) times(numbers.size(), () => numbers.int())
    })
  }
}
