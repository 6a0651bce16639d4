/** `make install`, and all that docs/c-library.md says of what it installs. */
import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'

const root = fileURLToPath(new URL('../..', import.meta.url))
const folder = mkdtempSync(join(tmpdir(), 'hexlens-install-'))
afterAll(() => rmSync(folder, { recursive: true }))

const manual = readFileSync(join(root, 'docs', 'c-library.md'), 'utf8')
const header = readFileSync(join(root, 'wasm', 'include', 'hexlens.h'), 'utf8')

/** The indented lines that begin with one of these words. */
function linesOfManual(...words: string[]): string[] {
  const lines = [...manual.matchAll(/^ {4}(\S.*)$/gm)].map(([, line]) => line as string)
  return lines.filter(line => words.some(word => line.startsWith(word)))
}

const printed = `${linesOfManual('Hexlens', 'The hexahedron', '2 of', 'Cell').join('\n')}\n`

/** The output of a command. The tools are to know of this installation alone. */
function run(command: string, args: readonly string[], env: Record<string, string> = {}): string {
  return execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: 'pipe', env: { ...process.env, ...env } })
}

function install(...variables: string[]): void {
  run('make', ['-s', '-C', join(root, 'wasm'), 'install', ...variables])
}

/** The installation is made for one place and used in another: it can be moved. */
const prefix = join(folder, 'staged', 'opt', 'hexlens')
const environment = { PKG_CONFIG_PATH: join(prefix, 'lib', 'pkgconfig') }

beforeAll(() => {
  install('PREFIX=/opt/hexlens', `DESTDIR=${join(folder, 'staged')}`)
  for (const language of ['c', 'cpp'])
    cpSync(join(root, 'docs', 'c', `example.${language}`), join(folder, `program.${language}`))
})

/** Configures and builds a folder of sources; gives the folder of the programs. */
function buildWithCMake(sources: string, name: string, ...options: string[]): string {
  const build = join(folder, name)
  run('cmake', ['-S', sources, '-B', build, ...options])
  run('cmake', ['--build', build])
  return build
}

describe('the example programs print what the manual says', () => {
  it.each(['hexlens::hexlens', 'hexlens::hexlens_static'])('by find_package, with %s', target => {
    const build = buildWithCMake(
      join(root, 'docs', 'c'),
      target.replace('::', '-'),
      `-DCMAKE_PREFIX_PATH=${prefix}`,
      `-DHEXLENS=${target}`,
    )
    expect(run(join(build, 'example-c'), [])).toBe(printed)
    expect(run(join(build, 'example-cpp'), [])).toBe(printed)
  })

  const commands = linesOfManual('cc ')
  it('by two commands', () => expect(commands).toHaveLength(2))

  const warnings = '-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror'
  it.each(
    commands.flatMap(command => [
      { compiler: `cc -std=c11 ${warnings}`, source: 'program.c', command },
      { compiler: `c++ -std=c++17 ${warnings}`, source: 'program.cpp', command },
    ]),
  )('by pkg-config, $source: $command', ({ compiler, source, command }) => {
    run('sh', ['-c', command.replace('cc', compiler).replace('program.c', source)], environment)
    const libraries = join(prefix, 'lib')
    expect(run('./program', [], { LD_LIBRARY_PATH: libraries, DYLD_LIBRARY_PATH: libraries })).toBe(printed)
  })

  it('with the path of the shared library in the program', () => {
    const path = /`(-Wl,-rpath,[^`]+)`/.exec(manual)?.[1]
    run('sh', ['-c', `${commands[0]} ${path}`], environment)
    expect(run('./program', [])).toBe(printed)
  })

  it('from folders of other names, one of them outside of the prefix, by the lines for CMake', () => {
    const other = join(folder, 'other')
    const libdir = join(other, 'lib', 'machine')
    install(`PREFIX=${other}`, `libdir=${libdir}`, `includedir=${join(folder, 'headers')}`)
    const sources = join(folder, 'sources')
    mkdirSync(sources)
    cpSync(join(folder, 'program.cpp'), join(sources, 'program.cpp'))
    const [find, ...link] = linesOfManual('find_package', 'target_link_libraries')
    const lines = ['cmake_minimum_required(VERSION 3.15)', 'project(program CXX)', 'set(CMAKE_CXX_STANDARD 17)']
    writeFileSync(
      join(sources, 'CMakeLists.txt'),
      [...lines, find, 'add_executable(program program.cpp)', ...link].join('\n'),
    )
    const build = buildWithCMake(sources, 'other-build', `-Dhexlens_DIR=${join(libdir, 'cmake', 'hexlens')}`)
    expect(run(join(build, 'program'), [])).toBe(printed)
    const path = { PKG_CONFIG_PATH: join(libdir, 'pkgconfig') }
    expect(run('pkg-config', ['--cflags', 'hexlens'], path).trim()).toBe(`-I${join(folder, 'headers')}`)
  })
})

it('links the static library into a shared one', () => {
  run('cc', [
    '-shared',
    '-fPIC',
    'program.c',
    `-I${prefix}/include`,
    `${prefix}/lib/libhexlens.a`,
    '-lm',
    '-o',
    'other.so',
  ])
})

it('shows the functions of the header and nothing else', () => {
  const functions = [...header.matchAll(/^(?!typedef)[a-z][\w ]*[ *](hl_\w+)\(/gm)].map(([, name]) => name)
  const isMac = process.platform === 'darwin'
  const shared = isMac ? 'libhexlens.dylib' : 'libhexlens.so'
  for (const [file, option] of [
    ['libhexlens.a', '-g'],
    [shared, isMac ? '-g' : '-D'],
  ] as const) {
    const symbols = run('nm', [option, '-P', join(prefix, 'lib', file)])
    const defined = [...symbols.matchAll(/^_?(\S+) [A-TV-Z] /gm)].map(([, name]) => name)
    expect(defined.toSorted()).toEqual(functions.toSorted())
  }
})

describe('the version', () => {
  const { version, author, homepage, repository, bugs } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'))
  const python = readFileSync(join(root, 'python', 'pyproject.toml'), 'utf8')

  it('is the same everywhere', () => {
    const macro = (name: string) => new RegExp(`^#define ${name} (\\S+)$`, 'm').exec(header)?.[1]
    const numbers = ['MAJOR', 'MINOR', 'PATCH'].map(number => macro(`HL_VERSION_${number}`))
    expect(macro('HL_VERSION')).toBe(`"${version}"`)
    expect(numbers.join('.')).toBe(version)
    expect(run('pkg-config', ['--modversion', 'hexlens'], environment).trim()).toBe(version)
    expect(answerOfCMake('')).toMatch(new RegExp(`^${version} `))
    expect(printed).toMatch(`Hexlens ${version}\n`) // what hl_version() said
    expect(python).toMatch(`version = "${version}"`)
  })

  it('has the same authors and addresses in Python', () => {
    expect(python).toMatch(`name = "${author}"`)
    expect(python).toMatch(`Homepage = "${homepage}"`)
    expect(python).toMatch(`Repository = "${repository.url.replace('git+', '')}"`)
    expect(python).toMatch(`Issues = "${bugs.url}"`)
  })

  /** The version file's answer for a version that is asked for. */
  function answerOfCMake(wanted: string): string {
    const script = join(folder, 'version.cmake')
    const file = join(prefix, 'lib', 'cmake', 'hexlens', 'hexlens-config-version.cmake')
    const answer = ['PACKAGE_VERSION', 'PACKAGE_VERSION_COMPATIBLE', 'PACKAGE_VERSION_EXACT']
    const lines = [
      `set(PACKAGE_FIND_VERSION "${wanted}")`,
      `include("${file}")`,
      `message(STATUS "${answer.map(name => `\${${name}}`).join(' ')}")`,
    ]
    writeFileSync(script, lines.join('\n'))
    return run('cmake', ['-P', script]).trim().replace(/^-- /, '')
  }

  const [major, minor, patch] = version.split('.').map(Number)
  it.each([
    [`${major}.${minor}`, 'TRUE'],
    [version, 'TRUE TRUE'],
    [`${major}.${minor}.${patch + 1}`, 'FALSE'],
    [`${major}.${minor + 1}`, 'FALSE'],
    [`${major + 1}.0`, 'FALSE'],
    ['0.0.9', 'FALSE'],
  ])('asked for %s is compatible: %s', (wanted, compatible) => {
    expect(answerOfCMake(wanted)).toMatch(new RegExp(`^${version} ${compatible}`))
  })
})
