/** @jsxImportSource preact */
import type { HexLens } from 'hexlens/preact'
import { createRef } from 'preact'

const lens = createRef<HexLens>()
export const Lens = () => (
  <hex-lens
    ref={lens}
    class="wide"
    vertices={[0, 1]}
    group="pair"
    onhex-camera={({ detail }) => lens.current?.moveCamera(detail, 1)}
  />
)

export const Mesh = () => <hex-mesh class="wide" src="part.vtu" onhex-pick={({ detail }) => detail.cell.toFixed()} />

// @ts-expect-error There is no such attribute.
export const wrong = <hex-lens colour="red" />
