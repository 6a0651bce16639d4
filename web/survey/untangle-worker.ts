/** The script of a worker that untangles a part of a mesh, and is ended afterwards. */
import { repairFiles } from '../core/repair/repair-files'
import { seldom, serve } from '../core/workers'
import { heldCertificates, type UntangleJobs, untangledPart } from './untangled-part'

serve<null, UntangleJobs>('hexlens-untangle', async () => {
  const core = await repairFiles()
  return {
    untangle: (wanted, tell) => untangledPart(core, wanted, seldom(tell)),
    certify: (wanted, tell) => heldCertificates(core, wanted, seldom(tell)),
  }
})
