/** The packed package’s types, as its users' compilers and frameworks see them. */
import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, readdirSync, readFileSync, symlinkSync } from 'node:fs'
import { join } from 'node:path'
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core'
import { publint } from 'publint'
import { formatMessage } from 'publint/utils'
import { elsewhere, expect, root, test } from './elsewhere'

/** Frameworks whose types the authors' code is checked with. */
const FRAMEWORKS = ['@types', 'preact', 'svelte', 'vue']

test('authors’ code of every kind passes tsc, with the declarations checked too', () => {
  cpSync(join(root, 'tests/package/authors'), join(elsewhere, 'authors'), { recursive: true })
  for (const name of FRAMEWORKS) {
    const link = join(elsewhere, 'node_modules', name)
    if (!existsSync(link)) symlinkSync(join(root, 'node_modules', name), link)
  }
  const tsc = join(root, 'node_modules/typescript/bin/tsc')
  const files = readdirSync(join(elsewhere, 'authors'))
  const flags = '--strict --exactOptionalPropertyTypes --skipLibCheck false --noEmit --target es2022 --jsx react-jsx'
  for (const module of ['--module nodenext', '--module esnext --moduleResolution bundler'])
    expect(
      tscOutput(join(elsewhere, 'authors'), [tsc, ...flags.split(' '), ...module.split(' '), '--types', '', ...files]),
    ).toBe('')
})

test('publint and “are the types wrong” have nothing against it', async () => {
  const installed = join(elsewhere, 'node_modules/hexlens')
  const { messages, pkg } = await publint({ pkgDir: installed, pack: false, strict: true })
  expect(messages.map(message => formatMessage(message, pkg, { color: false }))).toEqual([])
  const tarball = readdirSync(elsewhere).find(name => name.endsWith('.tgz')) ?? ''
  const analysis = await checkPackage(createPackageFromTarballData(readFileSync(join(elsewhere, tarball))))
  // It is of modules alone: neither `require` nor the resolution of Node before 12 knows them.
  const problems = analysis.types
    ? analysis.problems.filter(
        problem => !('resolutionKind' in problem && /^node10$|^node16-cjs$/.test(problem.resolutionKind)),
      )
    : ['no types']
  expect(problems).toEqual([])
})

function tscOutput(cwd: string, args: readonly string[]): string {
  try {
    return execFileSync(process.execPath, args, { cwd, encoding: 'utf8' })
  } catch (error) {
    return (error as { stdout: string }).stdout
  }
}
