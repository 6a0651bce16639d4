/** Defines `<hex-mesh>` with the worker that a build brings. */
import type { ReadingWorker } from '../input/input-reader'
import { HexMesh } from './hex-mesh'

/** The class that is registered: a second script leaves the first one's alone. A server has no registry. */
export function defineMesh(worker: ReadingWorker): typeof HexMesh {
  HexMesh.worker = worker
  const { customElements: registry } = globalThis
  if (registry && !registry.get('hex-mesh')) registry.define('hex-mesh', HexMesh)
  return (registry?.get('hex-mesh') as typeof HexMesh | undefined) ?? HexMesh
}
