/** Untangles a mesh in slices of time, so that a worker can tell of its progress and be cancelled. */
import type { Result } from '../../model/result'
import type { RepairCore } from './best-place'
import type { PointMesh, Untangled, UntangledCounts, UntangleError, UntangleOptions, Untangling } from './untangling'

/** Milliseconds from one look at the signal to the next. */
const SLICE = 30

/**
 * Moves points until all cells that they reach have the margin, or none gains; the mesh given is left as it is. Rejects with the
 * signal's reason if that aborts.
 */
export async function untangle(
  core: RepairCore,
  mesh: PointMesh,
  options: UntangleOptions,
  onProgress: (soFar: UntangledCounts) => void = () => {},
  signal?: AbortSignal,
): Promise<Result<Untangled, UntangleError>> {
  signal?.throwIfAborted()
  const begun = await core.untangling(mesh, options)
  if (!begun.ok) return begun
  while (isGoingOn(begun.value)) {
    onProgress(begun.value.progress())
    await new Promise(resolve => setTimeout(resolve))
    signal?.throwIfAborted()
  }
  return { ok: true, value: begun.value.end() }
}

function isGoingOn(untangling: Untangling): boolean {
  const end = performance.now() + SLICE
  while (untangling.step()) if (performance.now() >= end) return true
  return false
}
