// npm run peers: what VTK, meshio and Gmsh make of the files of ../shared/meshes/made, and of what Hexlens writes, into
// tests/formats/peers.json, from which npm run formats writes. The first time it installs them, as npm run bench does.

import { importSource } from './import-source.mjs'
import { runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup({ purpose: 'check', say: line => process.stderr.write(`${line}\n`) })
  const { main } = await importSource('tests/formats/peers.ts')
  await main()
})
