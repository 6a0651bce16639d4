/** `hexlens/hex-mesh`: importing it defines `<hex-mesh>`, a mesh in a page. It reads and decides in the worker beside the script. */
import { defineMesh } from '../mesh-element/define'
import type { HexMesh as Element } from '../mesh-element/hex-mesh'
import { readingWorkerBeside } from './mesh-worker-beside'
import './no-trace'

export type { HexMeshEventMap, MeshSummary, PickedCell } from '../mesh-element/events'
export { setMeshWorker } from './mesh-worker-beside'

/** The registered class, whichever copy of the script has brought it. */
export const HexMesh = defineMesh(readingWorkerBeside)
export type HexMesh = Element
