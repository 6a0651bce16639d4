/** The command line: what it prints and with which exit status. tools/hexlens.mjs runs it. */
import { readFile } from 'node:fs/promises'
import type { Check, Core } from '../core/report'
import { asDouble, decimalOf } from '../model/decimal'
import { certification } from './certificates'
import { fetchCore } from './read-core'
import { MalformedInput, type NamedHexahedron, readHexahedra } from './read-hexahedra'

const CALL = process.env.npm_lifecycle_event === 'hexlens' ? 'npm run -s hexlens --' : 'hexlens'

const USAGE = `Usage: ${CALL} analyze FILE.json
       ${CALL} certify FILE.json

Reads a JSON list of {"name", "vertices": [[x, y, z], ... 8 points in VTK_HEXAHEDRON order]} ("-": standard input) and
prints a JSON list of {"name", "valid", "class", "coincident", "shape", "boundary_min", "boundary_min_error", "minimizer",
"corner_min", "edge_min", "volume_min": [lower, upper], "volume_minimizer", "volume", "relative_min", "decided_by",
"checks"}, or of {"name", "error"} for what cannot be analysed, in the same order. jacdet is that of the map from [0,1]^3.

class         valid; invalid; inverted (jacdet < 0 everywhere); collapsed (jacdet = 0 everywhere)
coincident    the groups of vertices at the same position: [[4,5],[6,7]]
shape         wedge, pyramid or tetrahedron where the coincidences make one, else null
volume        the integral of jacdet
relative_min  boundary_min over |volume|, a number without a dimension; null where the volume is 0

certify prints {"name", "vertices", "valid", ...} with a proof: docs/certificates.md says which, and
tests/certificates/check_certificates.py checks it.
`

/** What is printed of each element, by the command's name. */
const commands = new Map([
  ['analyze', analysis],
  ['certify', certification],
])

const OK = 0
const REFUSED = 2

/** Enough digits to tell every double from every other. */
const DIGITS = 17

export interface Streams {
  readonly input: AsyncIterable<Buffer | string>
  readonly output: { write(text: string): unknown }
  readonly errors: { write(text: string): unknown }
}

const processStreams: Streams = { input: process.stdin, output: process.stdout, errors: process.stderr }

/** Runs one command; resolves to the exit status: 0, or 2 for a wrong call or input. */
export async function main(args: readonly string[], streams: Streams = processStreams): Promise<number> {
  if (args.length === 1 && (args[0] === '--help' || args[0] === '-h')) {
    streams.output.write(USAGE)
    return OK
  }
  const [name = '', file, ...more] = args
  const command = commands.get(name)
  if (command === undefined || file === undefined || more.length > 0) {
    streams.errors.write(USAGE)
    return REFUSED
  }
  try {
    const hexahedra = readHexahedra(await readText(file, streams.input))
    const core = await fetchCore()
    const lines = hexahedra.map(hexahedron => JSON.stringify(command(core, hexahedron)))
    streams.output.write(lines.length === 0 ? '[]\n' : `[\n${lines.join(',\n')}\n]\n`)
    return OK
  } catch (error) {
    if (!(error instanceof MalformedInput)) throw error
    streams.errors.write(`hexlens: ${error.message}\n`)
    return REFUSED
  }
}

async function readText(file: string, input: Streams['input']): Promise<string> {
  if (file !== '-') {
    try {
      return await readFile(file, 'utf8')
    } catch (error) {
      throw new MalformedInput(`The file ${file} cannot be read (${(error as NodeJS.ErrnoException).code}).`)
    }
  }
  const chunks: Buffer[] = []
  for await (const chunk of input) chunks.push(Buffer.from(chunk))
  return Buffer.concat(chunks).toString('utf8')
}

function analysis(core: Core, { name, vertices }: NamedHexahedron): object {
  const result = core.analyze(vertices)
  if (!result.ok) return { name, error: result.error.message }
  const report = result.value
  const { minimizer, volumeMinimum } = report
  const jacdet = (value: number) => jsonNumber(value, report.exponent)
  return {
    name,
    valid: report.valid,
    class: report.class,
    coincident: report.coincident,
    shape: report.shape,
    boundary_min: jacdet(report.boundaryMinimum),
    boundary_min_error: jacdet(report.boundaryMinimumError),
    minimizer: { kind: minimizer.kind, id: minimizer.id, point: minimizer.point },
    corner_min: jacdet(report.cornerMinimum),
    edge_min: jacdet(report.edgeMinimum),
    volume_min: [jacdet(volumeMinimum.lower), jacdet(volumeMinimum.upper)],
    volume_minimizer: volumeMinimum.point,
    volume: jsonNumber(report.volume, report.volumeExponent),
    relative_min: report.relativeMinimum,
    decided_by: report.decidedBy,
    checks: Object.fromEntries(report.checks.map(check => [check.id, checkJson(check, jacdet)])),
  }
}

/** A scaled Jacobian is a number as it is; the others are jacdets. */
function checkJson({ id, value, passes }: Check, jacdet: (value: number) => number | string): object {
  return { value: id === 'corners-and-centre' ? value : jacdet(value), passes }
}

/** A number that reads back bit for bit, or a decimal string where mantissa * 2^exponent is no double. */
function jsonNumber(mantissa: number, exponent: number): number | string {
  return asDouble(mantissa, exponent) ?? decimalOf(mantissa, exponent, DIGITS)
}
