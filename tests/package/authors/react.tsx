import { type HexLens, HexLensError } from 'hexlens/react'
import { useRef, useState } from 'react'

export function Lens() {
  const [vertices, setVertices] = useState<readonly number[]>([])
  const lens = useRef<HexLens>(null)
  return (
    <hex-lens
      ref={lens}
      className="wide"
      vertices={vertices}
      camera={{ direction: [1, 0, 0] }}
      views="scene verdict"
      hidden-faces="0 1"
      readonly
      onhex-change={({ target }) => setVertices((target as HexLens).vertices)}
      onhex-probe={({ detail }) => detail?.jacdet.toFixed(3)}
    >
      <p slot="caption">{String(HexLensError)}</p>
    </hex-lens>
  )
}

// @ts-expect-error There is no such attribute.
export const wrong = <hex-lens colour="red" />
// @ts-expect-error A camera has a direction.
export const nowhere = <hex-lens camera={{ zoom: 2 }} />
