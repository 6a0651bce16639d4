/** `check` as scripts meet it: the program itself with its exit status, and every option in-process. */
import { execFile, spawn } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import Ajv2020 from 'ajv/dist/2020.js'
import { afterAll, describe, expect, it } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { core, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { collapsedEdge, invalidCorner, mirroredCube, moved, mshText, notFinite, voxelOrder } from './mesh-fixtures'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-check-'))
afterAll(() => rmSync(folder, { recursive: true }))

function fileOf(name: string, content: string): string {
  const path = join(folder, name)
  writeFileSync(path, content)
  return path
}

const allValid = fileOf('valid.msh', mshText([unitCube, unitCube]))
const someInvalid = fileOf(
  'invalid.msh',
  mshText([unitCube, invalidCorner, collapsedEdge, mirroredCube, voxelOrder], 11),
)
const notAnswered = fileOf('unanswered.msh', mshText([unitCube, notFinite]))
const damaged = fileOf('damaged.msh', '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0\n')
const missing = join(folder, 'missing.msh')

function vtuText(element: readonly number[]): string {
  const array = (type: string, name: string, values: readonly number[]) =>
    `<DataArray type="${type}" Name="${name}" format="ascii">${values.join(' ')}</DataArray>`
  return `<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1">
    <Points>${array('Float64', 'Points', element)}</Points><Cells>${array('Int32', 'connectivity', [0, 1, 2, 3, 4, 5, 6, 7])}
    ${array('Int32', 'offsets', [8])}${array('UInt8', 'types', [12])}</Cells></Piece></UnstructuredGrid></VTKFile>`
}

async function check(args: readonly string[], input = '') {
  let [output, errors] = ['', '']
  const status = await main(['check', ...args], {
    input: (async function* () {
      yield Buffer.from(input)
    })(),
    output: { write: text => (output += text) },
    errors: { write: text => (errors += text) },
  })
  return { status, output, errors }
}

const schema = new Ajv2020().compile(
  JSON.parse(readFileSync(new URL('../../docs/check.schema.json', import.meta.url), 'utf8')),
)

async function checkedJson(...args: string[]) {
  const { status, output, errors } = await check(['--json', ...args])
  const json = JSON.parse(output)
  expect(schema(json), JSON.stringify(schema.errors)).toBe(true)
  expect([json.exit, errors]).toEqual([status, ''])
  return json
}

describe('the program', () => {
  const program = fileURLToPath(new URL('../../tools/hexlens.mjs', import.meta.url))
  const statusOf = async (...args: string[]) => {
    const { code, stdout, stderr } = await promisify(execFile)(process.execPath, [program, 'check', ...args]).then(
      done => ({ ...done, code: 0 }),
      failed => failed,
    )
    return { code, stdout, stderr }
  }

  it('ends with the status', async () => {
    expect(await statusOf(notAnswered)).toMatchObject({ code: 3 })
  })

  it('classifies more than a piece of cells on threads', async () => {
    const random = randomSource(5)
    const elements = Array.from({ length: 40_000 }, (_, i) =>
      i === 30_000 ? invalidCorner : randomHexahedron(random, 0.01),
    )
    const { code, stdout, stderr } = await statusOf(fileOf('large.msh', mshText(elements)), '--json', '--worst', '1')
    expect([code, stderr]).toEqual([1, ''])
    expect(JSON.parse(stdout).files[0]).toMatchObject({ hexahedra: 40_000, valid: 39_999, worst: [{ id: '30001' }] })
  })

  it('ends in one sentence and 2 where its output is closed or full', async () => {
    const random = randomSource(6)
    const many = fileOf('many.msh', mshText(Array.from({ length: 3000 }, () => randomHexahedron(random, 0.01))))
    const child = spawn(process.execPath, [program, 'check', '--json', '--worst', 'all', many])
    child.stdout.destroy()
    let errors = ''
    child.stderr.on('data', text => (errors += text))
    expect(await new Promise(resolve => child.on('close', resolve))).toBe(2)
    expect(errors).toBe('hexlens: Standard output cannot be written: whoever read it has closed it.\n')
    const list = fileOf(
      'list.json',
      JSON.stringify([{ name: 'a', vertices: [0, 1, 2, 3, 4, 5, 6, 7].map(v => unitCube.slice(3 * v, 3 * v + 3)) }]),
    )
    const shell = (command: string) => promisify(execFile)('sh', ['-c', command]).catch(failed => failed)
    if (existsSync('/dev/full'))
      for (const command of [`check "${allValid}"`, `analyze "${list}"`])
        expect(await shell(`"${process.execPath}" "${program}" ${command} > /dev/full`)).toMatchObject({
          code: 2,
          stderr: 'hexlens: Standard output cannot be written: the disk is full.\n',
        })
  })
})

/** As above, without a process for each. */
it('ends with 0, 1, 2 or 3', async () => {
  expect(await check([allValid])).toMatchObject({
    status: 0,
    output: expect.stringMatching(/2 hexahedra, all VALID/),
    errors: '',
  })
  expect(await check([someInvalid])).toMatchObject({ status: 1, errors: '' })
  expect(await check([damaged])).toMatchObject({ status: 2, errors: '' })
  expect(await check([notAnswered])).toMatchObject({ status: 3 })
})

it('ends with the gravest status of several files, with 0 where that is allowed, and with 2 without files', async () => {
  expect((await check([notAnswered, '--allow-unchecked'])).status).toBe(0)
  expect((await check([allValid, notAnswered, someInvalid, missing])).status).toBe(2)
  expect((await check([allValid, notAnswered, someInvalid])).status).toBe(1)
  expect(await check([])).toEqual({
    status: 2,
    output: '',
    errors: expect.stringMatching(/^hexlens: check: [^\n]+\n$/),
  })
})

describe('what people read', () => {
  it('is a verdict, notes, and the worst cells with what accepts them', async () => {
    const { output } = await check([someInvalid])
    const lines = output.split('\n')
    expect(lines[0]).toBe(`${someInvalid} (Gmsh): 5 hexahedra, 4 INVALID, 1 valid.`)
    expect(lines[1]).toBe('  1 hexahedron has coincident vertices.')
    expect(output).toMatch(/1 of 5 hexahedra is mirrored/)
    const rows = lines.slice(lines.findIndex(line => /^ +id +block +relative/.test(line)) + 1, -1)
    expect(rows.map(row => row.trim().split(/\s{2,}/)[0])).toEqual(['15', '12', '14', '13'])
    expect(rows[2]).toMatch(/14 {2,}left, wall {2,}-1 {2,}-1 {2,}vertex 0 {2,}none$/)
  })

  it('is the least of a mesh that is valid, or as many as are asked for', async () => {
    expect((await check([allValid])).output).toMatch(
      /all VALID\.\n {2}Least: relative minimum 1, minimum 1, id 1 at vertex 0\.\n$/,
    )
    expect((await check([allValid, '--worst=2'])).output).toMatch(/\n {4}1 .* all\n {4}2 .* all\n$/)
  })

  it('is for the time step that is asked for', async () => {
    for (const [i, element] of [unitCube, mirroredCube].entries()) fileOf(`${i}.vtu`, vtuText(element))
    const sets = [0, 1].map(i => `<DataSet timestep="${i}" file="${i}.vtu"/>`).join('')
    const steps = fileOf('steps.pvd', `<VTKFile type="Collection"><Collection>${sets}</Collection></VTKFile>`)
    expect((await check([steps])).status).toBe(0)
    const last = await check([steps, '--step', 'last'])
    expect([last.status, last.output.includes('Time step 2 of 2 was read')]).toEqual([1, true])
    expect(last.output).toContain('--step all checks every step.')
    expect((await check([steps, '--step=1'])).status).toBe(0)
    expect((await check([steps, '--step=3'])).status).toBe(2)
    expect((await check([steps, '--step=0'])).errors).toMatch(/--step wants a number from 1 on, last or all, not 0/)
  })

  it('is for a file with one time step or none: the first, the last and all are that one, and another is missing', async () => {
    fileOf('once.vtu', vtuText([...unitCube]))
    const set = '<DataSet timestep="0.5" file="once.vtu"/>'
    const once = fileOf('once.pvd', `<VTKFile type="Collection"><Collection>${set}</Collection></VTKFile>`)
    for (const file of [allValid, once]) {
      for (const step of ['1', 'last', 'all']) expect((await check([file, '--step', step])).status).toBe(0)
      const { status, output } = await check([file, '--step=99'])
      expect(status).toBe(2)
      expect(output).toMatch(/\.(?:msh|pvd): it has one time step, and step 99 was asked for\.\n$/)
    }
  })

  it('is for all time steps, and tells of the first with an invalid cell', async () => {
    const places = [1, 0.8, 0.9, 0.6, 0.3]
    const file = (at: number) => fileOf(`at-${at}.vtu`, vtuText(moved(6, [at, at, at])))
    for (const at of places) file(at)
    const pvd = (name: string, ats: readonly number[]) => {
      const sets = ats.map((at, i) => `<DataSet timestep="${i / 4}" file="at-${at}.vtu"/>`).join('')
      return fileOf(name, `<VTKFile type="Collection"><Collection>${sets}</Collection></VTKFile>`)
    }
    const { status, output } = await check([pvd('inverts.pvd', places), '--step', 'all'])
    expect([status, output.split('\n').slice(0, 4)]).toEqual([
      1,
      [
        `${join(folder, 'inverts.pvd')} (VTU): 1 hexahedron, 1 INVALID.`,
        '  Step 4 (t = 0.75) is the first with an invalid cell: cell 0.',
        '  All 5 time steps were checked, and 2 have invalid cells. What follows is of step 4 (t = 0.75).',
        '  Time step 4 of 5 was read: “0.75”.',
      ],
    ])
    const valid = pvd('holds.pvd', [1, 0.8, 0.9])
    const json = await checkedJson(valid, '--step=all', '--worst=0')
    const [{ step, steps, notes, worst }] = json.files
    expect([json.exit, step, steps.map(({ time }: { time: string }) => time), worst]).toEqual([
      0,
      2,
      ['0', '0.25', '0.5'],
      [],
    ])
    expect(notes[0]).toMatch(
      /^No step has an invalid cell\. The least relative minimum is 0\.47\d*: step 2 \(t = 0\.25\), cell 0\.$/,
    )
    // Below the bound from the second on, and the second is told of.
    expect((await check([valid, '--step=all', '--min-relative=0.9'])).status).toBe(1)
    const lacking = await check([pvd('lacking.pvd', [0.6, 1, 0.5]), '--step=all'])
    expect([lacking.status, lacking.output]).toEqual([
      2,
      expect.stringMatching(
        /Time step 3 of 3: lacking\.pvd: it needs “at-0\.5\.vtu” beside it.* Step 1 \(t = 0\) is the first with an invalid cell: cell 0\.\n$/,
      ),
    ])
    const one = await checkedJson(allValid, '--step=all')
    expect([one.files[0].steps, one.exit]).toEqual([undefined, 0])
  })

  it('says for each file what is wrong with it', async () => {
    const { status, output } = await check([damaged, missing, notAnswered])
    expect(status).toBe(2)
    expect(output).toMatch(/damaged\.msh: not read\.\n {2}damaged\.msh[^\n]+\n\n/)
    expect(output).toMatch(/missing\.msh: not read\.\n {2}missing\.msh cannot be read: it is not there\.\n\n/)
    expect(output).toMatch(/2 hexahedra, 1 valid, 1 unanswered/)
    expect(output).toMatch(/exit status 3, or 0 with --allow-unchecked/)
  })

  it('has no such characters where a file is not there', async () => {
    const { output, status } = await check(['no\u202esuch\u001b[31m.msh'])
    expect(status).toBe(2)
    expect(output).toContain('nosuch[31m.msh cannot be read')
    for (const character of ['\u202e', '\u001b']) expect(output).not.toContain(character)
  })

  it('has no control or bidirectional characters of names', async () => {
    const nasty = fileOf('nasty.msh', mshText([invalidCorner]).replace('left, wall', 'a\u202eb\u001b[31m'))
    expect((await check([nasty])).output).toMatch(/ab\[31m/)
    const { output } = await check([nasty, '--json'])
    expect(output).toMatch(/\\u202e/)
    for (const character of ['\u202e', '\u001b']) expect(output).not.toContain(character)
  })
})

describe('--json', () => {
  it('has the counts and the worst ten, numbers bit for bit', async () => {
    const { files } = await checkedJson(someInvalid, missing)
    expect(files[0]).toMatchObject({
      file: someInvalid,
      format: 'Gmsh',
      hexahedra: 5,
      valid: 1,
      invalid: 4,
      unanswered: 0,
      degenerate: 1,
      below: 0,
      not_trilinear: { count: 0, valid_by_corners: 0 },
      other: {},
    })
    expect(files[0].worst.map(({ id }: { id: string }) => id)).toEqual(['15', '12', '14', '13', '11'])
    const result = core.analyze(invalidCorner)
    if (!result.ok) throw new Error(result.error.message)
    const { boundaryMinimum, relativeMinimum, volume, minimizer, decidedBy, checks } = result.value
    expect(files[0].worst[1]).toEqual({
      id: '12',
      index: 1,
      block: 'left, wall',
      valid: false,
      class: 'invalid',
      coincident: [],
      shape: null,
      boundary_min: boundaryMinimum,
      relative_min: relativeMinimum,
      volume,
      minimizer: { kind: minimizer.kind, id: minimizer.id, point: minimizer.point },
      decided_by: decidedBy,
      accepted_by: checks.filter(({ passes }) => passes).map(({ id }) => id),
    })
    expect(files[1]).toEqual({ file: missing, error: 'missing.msh cannot be read: it is not there.' })
  })

  it('has every hexahedron with --worst all, those that are unanswered last, and values outside the doubles', async () => {
    const mesh = fileOf(
      'mixed.msh',
      mshText([notFinite, unitCube.map(x => 1e150 * x), ...Array.from({ length: 20 }, () => unitCube)]),
    )
    const { files } = await checkedJson(mesh, '--worst', 'all')
    const { worst } = files[0]
    expect(worst.length).toBe(22)
    expect(worst.at(-1)).toMatchObject({ id: '1', valid: null, error: 'Vertex 6 y is not a finite number.' })
    expect(worst.find(({ id }: { id: string }) => id === '2').boundary_min).toMatch(/^(9\.99|1\.00)\d+e\+4(49|50)$/)
    expect((await checkedJson(mesh, '--worst', '0')).files[0].worst).toEqual([])
    expect((await checkedJson(mesh)).files[0].worst.length).toBe(10)
  })
})

describe('options', () => {
  it('--min-relative and --degenerate=skip', async () => {
    expect(await checkedJson(allValid, '--min-relative', '1.5')).toMatchObject({
      exit: 1,
      files: [{ below: 2, invalid: 0 }],
    })
    expect(await checkedJson(allValid, '--min-relative', '-1')).toMatchObject({ exit: 0, files: [{ below: 0 }] })
    const degenerate = fileOf('degenerate.msh', mshText([unitCube, collapsedEdge]))
    expect(await checkedJson(degenerate)).toMatchObject({ exit: 1, files: [{ invalid: 1, degenerate: 1 }] })
    expect(await checkedJson(degenerate, '--degenerate=skip')).toMatchObject({
      exit: 0,
      files: [{ hexahedra: 2, valid: 1, invalid: 0, degenerate: 1 }],
    })
  })

  it('- with and without --format', async () => {
    const text = mshText([unitCube])
    for (const args of [['-'], ['-', '--format', 'gmsh'], ['--format=Gmsh', '--', '-']])
      expect(await check(args, text)).toMatchObject({
        status: 0,
        output: expect.stringMatching(/^- \(Gmsh\): 1 hexahedron, VALID/),
      })
    for (const name of ['none', 'not read yet', 'picture', 'link'])
      expect(await check(['-', '--format', name], text)).toMatchObject({
        status: 2,
        output: expect.stringMatching(new RegExp(`no format “${name}”: VTU, (?!.*(?:picture|link|not read yet))`)),
      })
  })

  it('--ids', async () => {
    expect((await check(['--ids', 'plain', someInvalid])).output).toBe('12\n13\n14\n15\n')
    expect((await check(['--ids', 'plain', '--degenerate=skip', someInvalid])).output).toBe('12\n14\n15\n')
    expect((await check(['--ids', 'abaqus', someInvalid])).output).toBe(
      '*ELSET, ELSET=HEXLENS_INVALID\n12, 13, 14, 15\n',
    )
    expect(await check(['--ids', 'plain', allValid])).toEqual({ status: 0, output: '', errors: '' })
    const many = fileOf(
      'many-invalid.msh',
      mshText(
        Array.from({ length: 100 }, () => mirroredCube),
        1_000_000,
      ),
    )
    const set = (await check(['--ids=nastran', many])).output
    expect(set).toMatch(/^SET 1 = 1000000,1000001,/)
    const lines = set.trimEnd().split('\n')
    expect(lines.every((line, i) => line.length <= 72 && line.endsWith(',') === i < lines.length - 1)).toBe(true)
    expect(set.match(/\d{7}/g)?.map(Number)).toEqual(Array.from({ length: 100 }, (_, i) => 1_000_000 + i))
    const elset = (await check(['--ids=abaqus', many])).output.trimEnd().split('\n')
    expect(elset.slice(1).every(line => line.split(',').length <= 16)).toBe(true)
    const several = await check(['--ids', 'abaqus', someInvalid, many, missing])
    expect(several.status).toBe(2)
    expect(several.errors).toMatch(/^hexlens: missing\.msh cannot be read/)
    expect(several.output.split('\n').filter(line => line.startsWith('*'))).toEqual([
      `** ${someInvalid}: 4 invalid`,
      '*ELSET, ELSET=HEXLENS_INVALID',
      `** ${many}: 100 invalid`,
      '*ELSET, ELSET=HEXLENS_INVALID_2',
    ])
  })

  it('--csv', async () => {
    const path = join(folder, 'out.csv')
    await check([someInvalid, notAnswered, missing, '--csv', path])
    const lines = readFileSync(path, 'utf8').split('\r\n')
    expect(lines[0]).toBe(
      'file,index,id,block,valid,class,boundary_min,relative_min,volume,xi,eta,zeta,decided_by,accepted_by',
    )
    expect(lines[1]).toBe(
      `${someInvalid},0,11,"left, wall",true,valid,1,1,1,0,0,0,filter,corners corners-and-centre gauss-2 gauss-3 edges bernstein subdivision tangents`,
    )
    expect(lines[5]).toMatch(/,4,15,"left, wall",false,invalid,-1,,0,/)
    expect(lines[7]).toBe(`${notAnswered},1,2,"left, wall",,,,,,,,,,`)
    expect(lines.length).toBe(9)
    const { files } = await checkedJson(someInvalid)
    for (const { index, boundary_min, accepted_by } of files[0].worst) {
      const fields = entry(lines, index + 1).split(',')
      expect([Number(fields[7]), fields.at(-1)]).toEqual([boundary_min, accepted_by.join(' ')])
    }
  })

  it('--junit', async () => {
    const path = join(folder, 'out.xml')
    await check([someInvalid, allValid, notAnswered, missing, '--junit', path, '--min-relative=0.5'])
    const xml = readFileSync(path, 'utf8')
    expect([...xml.matchAll(/<testsuite .*?(tests=.*)>/g)].map(([, counts]) => counts)).toEqual([
      'tests="4" failures="2" errors="0" skipped="0"',
      'tests="4" failures="0" errors="0" skipped="0"',
      'tests="4" failures="1" errors="0" skipped="0"',
      'tests="1" failures="0" errors="1" skipped="0"',
    ])
    expect(xml).toMatch(
      /<failure message="4 of 5 hexahedra invalid">id 15, block left, wall: relative minimum none, minimum -1 at vertex 2\n/,
    )
    expect(xml).toMatch(/jacdet &lt; 0 everywhere/)
    await check([notAnswered, '--allow-unchecked', '--junit', path])
    expect(readFileSync(path, 'utf8')).toMatch(/failures="0" errors="0" skipped="1"/)
  })

  it('--html', async () => {
    const path = join(folder, 'out.html')
    expect(await check([someInvalid, allValid, missing, '--html', path])).toMatchObject({ status: 2, errors: '' })
    const html = readFileSync(path, 'utf8')
    const headings = [...html.matchAll(/<h[12] class="headline">(.*?)<\/h/g)].map(([, text]) => text)
    expect(headings).toEqual([
      '3 meshes',
      '4 of 5 hexahedra are invalid. The eight corners would accept none of them, VTK’s scaled Jacobian 2.',
      'All 2 hexahedra are valid.',
      'The file was not read.',
    ])
    expect([...html.matchAll(/<h4>Cell (\d+)/g)].map(([, id]) => id)).toEqual(['15', '12', '14', '13', '11', '1', '2'])
    expect(html).toContain('<p>missing.msh cannot be read: it is not there.</p>')
    await check([someInvalid, '--html', path, '--worst', '2'])
    expect(readFileSync(path, 'utf8').match(/<h3>Cell/g)).toHaveLength(2)
  })

  it.each(['out', 'out.vtu', '.hidden', 'of.a.Vtu'])('--annotate %s', async name => {
    const path = join(folder, name)
    const mesh = fileOf('annotated.msh', mshText([unitCube, invalidCorner, notFinite, moved(6, [2, 2, 2])]))
    expect((await check([mesh, '--annotate', path])).status).toBe(1)
    const { head, array } = readAppended(readFileSync(path))
    expect(head).toMatch(/<Piece NumberOfPoints="32" NumberOfCells="4">/)
    expect([...array('valid', bytes => bytes)]).toEqual([1, 0, 255, 1])
    const minima = array('boundary_min', doubles)
    const { files } = await checkedJson(mesh, '--worst', 'all')
    for (const { index, boundary_min, relative_min, volume } of files[0].worst) {
      expect(minima[index]).toBe(boundary_min ?? Number.NaN)
      expect(array('relative_min', doubles)[index]).toBe(relative_min ?? Number.NaN)
      expect(array('volume', doubles)[index]).toBe(volume ?? Number.NaN)
    }
    expect([...array('Points', doubles).subarray(24, 48)]).toEqual(invalidCorner)
    const connectivity = array('connectivity', bytes => new Int32Array(bytes.slice().buffer))
    expect([...connectivity]).toEqual(Array.from({ length: 32 }, (_, i) => i))
    expect([...array('offsets', bytes => new Int32Array(bytes.slice().buffer))]).toEqual([8, 16, 24, 32])
    expect([...array('types', bytes => bytes)]).toEqual([12, 12, 12, 12])
  })

  it('leave no part of a file behind, and overwrite nothing that is read', async () => {
    const before = readdirSync(folder)
    expect(await check([allValid, '--csv', join(folder, 'none', 'x.csv')])).toMatchObject({
      status: 2,
      errors: expect.stringMatching(/x\.csv cannot be written: there is no such folder\.\n$/),
    })
    expect(await check([allValid, '--annotate', allValid])).toMatchObject({
      status: 2,
      errors: expect.stringMatching(/would overwrite/),
    })
    const csv = join(folder, 'same')
    expect(await check([allValid, '--csv', csv, '--junit', csv])).toMatchObject({ status: 2 })
    expect(await check([allValid, '--html', allValid])).toMatchObject({ errors: expect.stringMatching(/--html would/) })
    expect(await check([allValid, '--html', csv, '--csv', csv])).toMatchObject({ status: 2 })
    expect(readdirSync(folder)).toEqual(before)
  })

  it('that are wrong are refused in one sentence', async () => {
    for (const args of [
      [],
      ['--nothing', allValid],
      ['--worst', '-1', allValid],
      ['--worst=', allValid],
      [allValid, '--worst'],
      ['--min-relative', 'x', allValid],
      ['--degenerate', 'keep', allValid],
      ['--ids', 'ansys', allValid],
      ['--json=yes', allValid],
      ['--json', '--json', allValid],
      ['--json', '--ids', 'plain', allValid],
      ['--annotate', join(folder, 'x.vtu'), allValid, someInvalid],
      ['--annotate', join(folder, 'x.cgns'), allValid],
      ['-', '-'],
    ])
      expect(await check(args)).toEqual({
        status: 2,
        output: '',
        errors: expect.stringMatching(/^hexlens: check: [^\n]+ hexlens check --help says what there is\.\n$/),
      })
  })

  it('--help is help wherever it stands', async () => {
    for (const args of [['--help'], [allValid, '-h'], ['--json', '--help']])
      expect(await check(args)).toMatchObject({
        status: 0,
        output: expect.stringMatching(/^Usage: .* check /),
        errors: '',
      })
  })

  it('progress is shown on a terminal alone, and goes', async () => {
    let errors = ''
    const streams = {
      input: (async function* () {})(),
      output: { write: () => {} },
      errors: { write: (text: string) => (errors += text), isTTY: true },
    }
    const random = randomSource(8)
    const path = fileOf('slow.msh', mshText(Array.from({ length: 30_000 }, () => randomHexahedron(random, 0.01))))
    await main(['check', path], streams)
    const shown = errors.split('\r\u001b[K')
    expect([shown[0], shown.at(-1)]).toEqual(['', ''])
    expect(shown.slice(1, -1).join('\n')).toMatch(/^(.*: (reading|deciding): \d+ %\n?)+$/)
  })
})

function doubles(bytes: Uint8Array): Float64Array {
  return new Float64Array(bytes.slice().buffer)
}

/** An uncompressed VTU with appended raw data and a header of eight bytes an array. */
function readAppended(file: Buffer) {
  const start = file.indexOf('_', file.indexOf('<AppendedData'))
  const head = file.subarray(0, start).toString('latin1')
  const array = <T>(name: string, read: (bytes: Uint8Array) => T): T => {
    const [, offset] = new RegExp(`Name="${name}"[^>]*offset="(\\d+)"`).exec(head) ?? []
    const from = start + 1 + Number(offset)
    const length = Number(file.readBigUInt64LE(from))
    return read(new Uint8Array(file.subarray(from + 8, from + 8 + length)))
  }
  return { head, array }
}
