/** The Python packages of tests/bench/requirements.txt, in an environment of their own under build. */
import { spawnSync } from 'node:child_process'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

export const root = fileURLToPath(new URL('../..', import.meta.url))
const requirements = join(root, 'tests', 'bench', 'requirements.txt')

/** The folder for what benchmarks write. */
export const folder = join(root, 'build', 'bench')
export const python = join(folder, 'python', 'bin', 'python')

export function script(name: string): string {
  return join(root, 'tests', 'bench', name)
}

export function installPeers(): void {
  const stamp = join(folder, 'python', 'hexlens-stamp')
  const text = readFileSync(requirements, 'utf8')
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === text) return
  process.stderr.write('bench: installing VTK, PyVista, meshio and Gmsh into build/bench/python\n')
  mkdirSync(folder, { recursive: true })
  must('python3', ['-m', 'venv', join(folder, 'python')])
  must(python, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', '-r', requirements])
  writeFileSync(stamp, text)
}

/** The command's standard output; throws an Error with what it complains of if it fails. */
export function must(command: string, args: readonly string[]): string {
  const { status, stdout, stderr } = spawnSync(command, args, { encoding: 'utf8', cwd: root })
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}: ${stderr}`)
  return stdout
}

/** The versions of packages of these names: "pyvista 0.49.0, vtk 9.7.0". */
export function versionsOf(names: readonly string[]): string {
  return readFileSync(requirements, 'utf8')
    .split('\n')
    .filter(line => names.some(name => line.startsWith(name)))
    .map(line => line.replace(/[=~]=/, ' '))
    .join(', ')
}
