// Sets everything up that building, serving and testing need: npm packages, make, emcc, the wasm; for tests also C and
// C++ compilers, CMake, pkg-config, a clang with libFuzzer, Python, Chromium and, on Linux, Firefox and WebKitGTK; for
// the tests in foreign hosts Sphinx, MkDocs and JupyterLab. Each
// step is quick when there is nothing to do, and either completes or leaves nothing behind. Plain Node without
// dependencies: it installs them.

import { createHash } from 'node:crypto'
import { existsSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { dirname, join } from 'node:path'
import { parseArgs } from 'node:util'
import { findFirefox, findWebKitDriver, findXvfb, hasOtherBrowsers } from './browsers.mjs'
import { findChromium } from './chromium.mjs'
import { withLock } from './lock.mjs'
import { executable, Failure, failedCommand, isScript, must, onPath, root, run, runMain } from './run.mjs'

const EMSDK_VERSION = '4.0.10'
const EMSDK_SOURCE = 'https://github.com/emscripten-core/emsdk.git'
const EMSDK_FOLDER = join(root, '.emsdk')

/** Purposes of a setup: build and serve; formatter, linter, C warnings; benchmarks; all tests; those in foreign hosts; the Python package. */
const PURPOSES = ['start', 'check', 'bench', 'unit', 'test', 'hosts', 'python']

/** Python packages by what needs them: where they are installed, and the file that names them. */
const testsPython = { folder: 'build/python', requirements: 'tests/property/requirements.txt' }
const packagePython = { folder: 'build/package-python', requirements: 'python/tests/requirements.txt' }
const hostsPython = { folder: 'build/hosts/python', requirements: 'tests/hosts/requirements.txt' }

/** `beside`: it is awaited in the end, or before a step that `needsAll`. What such a step needs comes before it. */
const steps = [
  { what: 'Node', isDone: nodeIsNewEnough, run: refuseNode },
  { what: 'the npm packages', isDone: packagesAreCurrent, run: installPackages, beside: true },
  { what: 'python3', isDone: pythonStarts, run: installPython, for: ['check', 'unit', 'test', 'hosts', 'python'] },
  ...[
    { python: testsPython, for: ['unit', 'test'] },
    { python: hostsPython, for: ['hosts'] },
    { python: packagePython, for: ['python'] },
  ].map(({ python, for: purposes }) => ({
    what: `the Python packages of ${python.requirements}`,
    isDone: () => pythonPackagesAreCurrent(python),
    run: say => installPythonPackages(say, python),
    for: purposes,
    beside: true,
  })),
  { what: 'make', isDone: () => onPath('make'), run: installMake },
  {
    what: 'a C compiler',
    isDone: () => onPath('cc'),
    run: installCompiler,
    for: ['check', 'bench', 'unit', 'test', 'hosts', 'python'],
  },
  ...[
    { what: 'a C++ compiler', command: 'c++', debian: 'g++' },
    { what: 'CMake', command: 'cmake', debian: 'cmake' },
    { what: 'pkg-config', command: 'pkg-config', debian: 'pkg-config' },
  ].map(({ what, command, debian }) => ({
    what,
    isDone: () => onPath(command),
    run: say => installDebianPackages(say, what, [debian]),
    for: command === 'cmake' ? ['check', 'unit', 'test', 'hosts', 'python'] : ['check', 'unit', 'test'],
  })),
  {
    what: 'the wasm and its twin',
    isDone: () => isMade('wasm'),
    run: say => makeWithEmcc(say, 'wasm', 'the wasm and its twin'),
  },
  {
    what: 'what the benchmarks run',
    isDone: () => isMade('bench'),
    run: say => makeWithEmcc(say, 'bench', 'what the benchmarks run'),
    for: ['bench'],
  },
  { what: 'a clang with libFuzzer', isDone: clangLinksFuzzer, run: installFuzzer, for: ['unit', 'test'] },
  {
    what: 'a Chromium that starts',
    isDone: findChromium,
    run: installChromium,
    for: ['bench', 'test', 'hosts'],
    needsAll: true,
  },
  { what: 'the fonts of the visual tests', isDone: hasVisualFonts, run: installVisualFonts, for: ['test'] },
  { what: 'Firefox, WebKitGTK and a screen for them', isDone: otherBrowsers, run: installOtherBrowsers, for: ['test'] },
]

/** Does what is missing for a purpose. `say` gets a line for each step with something to do. Throws a Failure. */
export async function setup({ purpose = 'start', say = line => process.stdout.write(`${line}\n`) } = {}) {
  const wanted = steps.filter(step => !step.for || step.for.includes(purpose))
  if (await allDone(wanted)) return
  await withLock(join(root, 'build', 'setup.lock'), say, async () => {
    const beside = []
    for (const step of wanted) {
      if (step.needsAll) await Promise.all(beside)
      if (await step.isDone()) continue
      const done = complete(step, say)
      if (!step.beside) await done
      else beside.push(done)
    }
    await Promise.all(beside)
  })
}

/** Resolves when the step is done; whoever waits for it gets its Failure, also if another one came first. */
function complete(step, say) {
  const completed = async () => {
    await step.run(line => say(`setup: ${line}`))
    if (!(await step.isDone())) throw new Failure(`Setup went through, but ${step.what} cannot be found afterwards.`)
  }
  const done = completed()
  done.catch(() => {})
  return done
}

async function allDone(wanted) {
  for (const step of wanted) if (!(await step.isDone())) return false
  return true
}

/** The range of Vite 8. */
function nodeIsNewEnough() {
  const [major, minor] = process.versions.node.split('.').map(Number)
  return major === 20 ? minor >= 19 : major === 22 ? minor >= 12 : major > 22
}

function refuseNode() {
  throw new Failure(`Hexlens needs Node 20.19, 22.12 or later; this is ${process.version}. Install one, then repeat.`)
}

const packagesStampFile = join(root, 'node_modules', '.hexlens-stamp')

/** The key of the installed packages: another lock file or machine needs another install. */
function packagesStamp() {
  const lock = readFileSync(join(root, 'package-lock.json'))
  return `${createHash('sha256').update(lock).digest('hex')} ${process.platform} ${process.arch}\n`
}

function packagesAreCurrent() {
  return existsSync(packagesStampFile) && readFileSync(packagesStampFile, 'utf8') === packagesStamp()
}

async function installPackages(say) {
  say('installing the npm packages')
  rmSync(packagesStampFile, { force: true })
  const npm = process.env.npm_execpath?.endsWith('.js') ? [process.execPath, process.env.npm_execpath] : ['npm']
  const [command, ...args] = [...npm, 'ci', '--include=dev', '--ignore-scripts', '--no-audit', '--no-fund']
  await must(
    command,
    [...args, '--loglevel=error'],
    'Check that the npm registry can be reached (npm ping) and that this folder can be written, then repeat.',
  )
  writeFileSync(packagesStampFile, packagesStamp())
}

async function installMake(say) {
  await installDebianPackages(say, 'make', ['make'])
}

async function installCompiler(say) {
  await installDebianPackages(say, 'a C compiler', ['gcc', 'libc6-dev'])
}

async function isMade(target) {
  return (await run('make', ['-C', 'wasm', '-q', target])).status === 0
}

async function makeWithEmcc(say, target, what) {
  const emcc = findEmcc() ?? (await installEmcc(say))
  const wasm2js = findWasm2js(emcc) ?? (await installWasm2js(say, emcc))
  say(`building ${what}`)
  await must(
    'make',
    ['-C', 'wasm', `-j${availableParallelism()}`, target, `EMCC=${emcc.path}`, `WASM2JS=${wasm2js}`],
    `It did not build with ${emcc.path}. If the C sources are as released, try another emcc (3.1.6 or later).`,
    { env: { ...process.env, ...emcc.env } },
  )
}

/** An emcc that is there, with the environment it needs, or undefined. */
function findEmcc() {
  const path = onPath('emcc')
  if (path) return { path, env: {} }
  for (const folder of [process.env.EMSDK, EMSDK_FOLDER].filter(Boolean)) {
    const emcc = executable(join(folder, 'upstream', 'emscripten', 'emcc'))
    const config = join(folder, '.emscripten')
    if (emcc) return { path: emcc, env: existsSync(config) ? { EMSDK: folder, EM_CONFIG: config } : {} }
  }
  return undefined
}

async function installEmcc(say) {
  if (await aptGet()) await installDebianPackages(say, 'emcc', ['emscripten'])
  else await installEmsdk(say)
  const emcc = findEmcc()
  if (emcc) return emcc
  throw new Failure('emcc was installed but cannot be found. Put emcc on PATH or set EMSDK, then repeat.')
}

/** Finds binaryen's wasm2js: the SDK has its own, Debian's emscripten depends on it. */
function findWasm2js(emcc) {
  return executable(join(dirname(emcc.path), '..', 'bin', 'wasm2js')) ?? onPath('wasm2js')
}

async function installWasm2js(say, emcc) {
  await installDebianPackages(say, 'wasm2js', ['binaryen'])
  const wasm2js = findWasm2js(emcc)
  if (wasm2js) return wasm2js
  throw new Failure(`wasm2js was installed but cannot be found. ${installAdvice(['binaryen'])}`)
}

/** The official SDK into .emsdk, elsewhere until it is complete. */
async function installEmsdk(say) {
  const missing = ['git', 'python3', 'xz'].filter(name => !onPath(name))
  if (missing.length > 0) throw new Failure(`Hexlens needs emcc, and its SDK needs more. ${installAdvice(missing)}`)
  say(`installing the emscripten SDK ${EMSDK_VERSION} into .emsdk (some minutes)`)
  const partial = join(root, 'build', 'emsdk-partial')
  const byHand = onPath('apt-get') ? 'run `sudo apt-get install emscripten`' : 'install emcc (on PATH or in $EMSDK)'
  const advice = `Check that the address can be reached, or ${byHand}, then repeat.`
  rmSync(partial, { recursive: true, force: true })
  try {
    await must('git', ['clone', '--quiet', '--depth=1', '--branch', EMSDK_VERSION, EMSDK_SOURCE, partial], advice, {
      env: { ...process.env, GIT_TERMINAL_PROMPT: '0' },
    })
    for (const verb of ['install', 'activate']) {
      await must(join(partial, 'emsdk'), [verb, EMSDK_VERSION], advice, { cwd: partial })
    }
    rmSync(EMSDK_FOLDER, { recursive: true, force: true })
    renameSync(partial, EMSDK_FOLDER)
  } finally {
    rmSync(partial, { recursive: true, force: true })
  }
}

/** Links a program: libFuzzer and the sanitizers are packages of their own. */
async function clangLinksFuzzer() {
  return (await run('make', ['-C', 'wasm', '-s', 'fuzz-compiler'])).status === 0
}

/** Packages whose names are not Debian's. */
const FUZZER_PACKAGES = {
  dnf: ['clang', 'compiler-rt'],
  pacman: ['clang', 'compiler-rt'],
  apk: ['clang', 'compiler-rt'],
  brew: ['llvm'],
}

async function installFuzzer(say) {
  const what = 'a clang that links libFuzzer (-fsanitize=fuzzer,address,undefined) for the native tests'
  if (!(await aptGet())) {
    const manager = packageManager()?.name
    const packages = manager === 'apt-get' ? await debianFuzzerPackages() : (FUZZER_PACKAGES[manager] ?? ['clang'])
    throw new Failure(`Hexlens needs ${what}. ${installAdvice(packages)}`)
  }
  if (!(await clangMajor())) await installDebianPackages(say, what, ['clang'])
  if (!(await clangLinksFuzzer())) await installDebianPackages(say, what, await debianFuzzerPackages())
}

/** Compiler and runtime of one version: that of the clang that is there. */
async function debianFuzzerPackages() {
  const major = await clangMajor()
  return major ? [`clang-${major}`, `libclang-rt-${major}-dev`] : ['clang']
}

async function clangMajor() {
  const newestFirst = Array.from({ length: 14 }, (_, i) => `clang-${24 - i}`)
  const clang = onPath('clang', ...newestFirst)
  return clang && /clang version (\d+)/.exec((await run(clang, ['--version'])).text)?.[1]
}

async function pythonStarts() {
  return (await run('python3', ['--version'])).status === 0
}

async function installPython(say) {
  await installDebianPackages(say, 'python3', ['python3'])
}

const pythonStampOf = ({ folder }) => join(root, folder, 'hexlens-stamp')
const requirementsOf = ({ requirements }) => readFileSync(join(root, requirements), 'utf8')

function pythonPackagesAreCurrent(python) {
  const stamp = pythonStampOf(python)
  return existsSync(stamp) && readFileSync(stamp, 'utf8') === requirementsOf(python)
}

async function installPythonPackages(say, python) {
  const { folder, requirements } = python
  say(`installing the Python packages of ${requirements} into ${folder}`)
  const environment = join(root, folder)
  rmSync(environment, { recursive: true, force: true })
  const venv = ['-m', 'venv', environment]
  // Debian has venv in a package of its own.
  if ((await run('python3', venv)).status !== 0) {
    await installDebianPackages(say, 'python3 -m venv', ['python3-venv'])
    await must('python3', venv, 'Install what python3 needs to make a virtual environment, then repeat.')
  }
  const interpreter = join(environment, 'bin', 'python')
  const advice = 'Check that the Python package index can be reached (Python 3.11 or later is needed), then repeat.'
  await must(interpreter, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', 'uv'], advice)
  const words = ['pip', 'install', '--quiet', '--python', interpreter, '-r', join(root, requirements)]
  await must(join(environment, 'bin', 'uv'), words, advice)
  writeFileSync(pythonStampOf(python), requirementsOf(python))
}

async function installChromium(say) {
  const apt = await aptGet()
  if (apt && isDebian()) {
    await installDebianPackages(say, 'Chromium', ['chromium-headless-shell'])
    return
  }
  say('installing Chromium for the browser tests (playwright install)')
  const playwright = join(root, 'node_modules', '@playwright', 'test', 'cli.js')
  await must(
    process.execPath,
    [playwright, 'install', '--no-shell', ...(apt ? ['--with-deps'] : []), 'chromium'],
    'Check that the address can be reached, or install Chromium or Chrome yourself (on PATH), then repeat.',
  )
  if (await findChromium()) return
  throw new Failure(`Playwright's Chromium does not start here: it lacks libraries. ${installAdvice(['chromium'])}`)
}

/** Folders in which systems put DejaVu; tests/visual/fonts.conf has the same. */
const FONT_FOLDERS = ['/usr/share/fonts/truetype/dejavu', '/usr/share/fonts/TTF', '/usr/share/fonts/dejavu']
const VISUAL_FONTS = ['DejaVuSans.ttf', 'DejaVuSans-Bold.ttf', 'DejaVuSansMono.ttf', 'DejaVuMathTeXGyre.ttf']

function hasVisualFonts() {
  const isThere = font => FONT_FOLDERS.some(folder => existsSync(join(folder, font)))
  return !hasOtherBrowsers || VISUAL_FONTS.every(isThere)
}

async function installVisualFonts(say) {
  await installDebianPackages(say, 'the fonts of the visual tests', ['fonts-dejavu-core', 'fonts-dejavu-extra'])
}

/** Names where they are not Debian's. */
const OTHER_BROWSERS = {
  dnf: ['firefox', 'webkit2gtk4.1', 'xorg-x11-server-Xvfb'],
  pacman: ['firefox', 'webkit2gtk-4.1', 'xorg-server-xvfb'],
  apk: ['firefox-esr', 'webkit2gtk-4.1', 'xvfb'],
}

function otherBrowsers() {
  return !hasOtherBrowsers || (findFirefox() && findWebKitDriver() && findXvfb())
}

async function installOtherBrowsers(say) {
  const debian = [
    ...(findFirefox() ? [] : [isDebian() ? 'firefox-esr' : 'firefox']),
    ...(findWebKitDriver() ? [] : ['webkit2gtk-driver']),
    ...(findXvfb() ? [] : ['xvfb']),
  ]
  const manager = packageManager()?.name
  if (manager === 'apt-get') await installDebianPackages(say, 'Firefox and WebKitGTK for the browser tests', debian)
  else {
    const packages = OTHER_BROWSERS[manager] ?? ['Firefox', 'the WebKitWebDriver of WebKitGTK', 'Xvfb']
    throw new Failure(
      `Hexlens needs Firefox, WebKitWebDriver and Xvfb for the browser tests. ${installAdvice(packages)}`,
    )
  }
}

function isDebian() {
  return existsSync('/etc/os-release') && /^ID="?debian"?$/m.test(readFileSync('/etc/os-release', 'utf8'))
}

/** The words that install Debian packages without a question, or undefined where that is not possible. */
async function aptGet() {
  const apt = process.platform === 'linux' && onPath('apt-get')
  if (!apt) return undefined
  const words = ['env', 'DEBIAN_FRONTEND=noninteractive', apt, '-q', '-y', '-o', 'DPkg::Lock::Timeout=120']
  if (process.getuid() === 0) return words
  const sudo = onPath('sudo')
  return sudo && (await run(sudo, ['-n', 'true'])).status === 0 ? [sudo, '-n', ...words] : undefined
}

let listsUpdated = false
let lastInstall = Promise.resolve()

/** One after another: apt-get locks its lists and packages. */
function installDebianPackages(say, what, packages) {
  const install = lastInstall.then(() => installWithAptGet(say, what, packages))
  lastInstall = install.catch(() => {})
  return install
}

async function installWithAptGet(say, what, packages) {
  const words = await aptGet()
  if (!words) throw new Failure(`Hexlens needs ${what}. ${installAdvice(packages)}`)
  say(`installing ${what} (apt-get install ${packages.join(' ')})`)
  const [command, ...options] = words
  // A list that cannot be fetched matters only when a package is then not found: its message goes with that one.
  const update = listsUpdated ? undefined : await run(command, [...options, 'update'])
  listsUpdated = true
  const install = [...options, 'install', '--no-install-recommends', ...packages]
  const { status, text } = await run(command, install)
  if (status === 0) return
  const outputs = { status, text: update && update.status !== 0 ? `${update.text}\n${text}` : text }
  throw new Failure(failedCommand([command, ...install], outputs, installAdvice(packages)))
}

const PACKAGE_MANAGERS = [
  { name: 'apt-get', install: 'sudo apt-get install' },
  { name: 'dnf', install: 'sudo dnf install' },
  { name: 'pacman', install: 'sudo pacman -S' },
  { name: 'zypper', install: 'sudo zypper install' },
  { name: 'apk', install: 'sudo apk add' },
  { name: 'brew', install: 'brew install' },
]

function packageManager() {
  return PACKAGE_MANAGERS.find(({ name }) => onPath(name))
}

function installAdvice(packages) {
  const install = packageManager()?.install
  if (install) return `Run \`${install} ${packages.join(' ')}\`, then repeat.`
  return `Install ${packages.join(', ')}, then repeat.`
}

if (isScript(import.meta.url)) {
  await runMain(async () => {
    const { values } = parseArgs({ options: { for: { type: 'string', default: 'start' } } })
    if (!PURPOSES.includes(values.for)) throw new Failure(`--for takes one of: ${PURPOSES.join(', ')}.`)
    await setup({ purpose: values.for })
  })
}
