/** The elements of an XDMF file, without the numbers that stand in them, and the paths by which they refer to each other. */
import type { MeshFile } from '../source'
import { shown } from '../text-cursor'
import { XmlScanner } from '../xml-scanner'

export interface XmlNode {
  readonly name: string
  readonly attributes: ReadonlyMap<string, string>
  readonly children: readonly XmlNode[]
  /** Bytes of the file from behind the opening tag to the first one inside, or to the closing one. */
  readonly from: number
  readonly to: number
}

interface OpenNode extends XmlNode {
  readonly children: XmlNode[]
  to: number
}

/** One inside of another, at most. */
const DEEPEST = 64

/** The root. Refuses what is no XML, or ends early. */
export function treeOf(file: MeshFile, root: string, onTag: (position: number) => void): XmlNode {
  const scanner = new XmlScanner(file)
  const open: OpenNode[] = []
  for (let tag = scanner.next(); tag !== null; tag = scanner.next()) {
    onTag(tag.to)
    const top = open.at(-1)
    if (top === undefined && (tag.kind === 'close' || tag.name !== root)) continue
    if (top !== undefined && top.to < 0) top.to = tag.from
    if (tag.kind === 'open') {
      const node: OpenNode = { name: tag.name, attributes: tag.attributes, children: [], from: tag.to, to: -1 }
      top?.children.push(node)
      if (tag.isEmpty) node.to = tag.to
      else open.push(node)
      if (open.length > DEEPEST) scanner.refuse(tag.from, 'tags are nested deeper than those of a mesh are.')
      continue
    }
    const closed = open.pop() as OpenNode
    if (closed.name !== tag.name)
      scanner.refuse(
        tag.from,
        `</${shown(tag.name).slice(1, -1)}> stands where </${shown(closed.name).slice(1, -1)}> was expected.`,
      )
    if (open.length === 0) return closed
  }
  return scanner.refuse(file.size, `<${root}> ends nowhere: the file is cut off.`)
}

export function childrenOf(node: XmlNode, name: string): readonly XmlNode[] {
  return node.children.filter(child => child.name === name)
}

const STEP = /^(\*|\w+)((?:\[[^\]]*\])*)$/
const IS_NAME = /^@Name\s*=\s*["']([^"']*)["']$/
const SELF = /self::(\w+)/g

/**
 * The nodes that a path names, as XDMF has them: /Xdmf/Domain/Grid[@Name="a"]/Grid[1]/Geometry, //Grid[@Name="a"], and a step
 * *[self::Topology or self::Geometry]. Null for a path of another kind.
 */
export function resolved(root: XmlNode, path: string): readonly XmlNode[] | null {
  const isAnywhere = path.startsWith('//')
  const steps = path.replace(/^\/+/, '').split(/\/(?![^[]*\])/)
  let found: readonly XmlNode[] = isAnywhere ? allBelow(root) : [{ ...root, name: '', children: [root] }]
  for (const [i, step] of steps.entries()) {
    const [, name = '', conditions = ''] = STEP.exec(step.trim()) ?? []
    if (name === '') return null
    let next = i === 0 && isAnywhere ? found.filter(node => node.name === name) : found.flatMap(node => node.children)
    if (name !== '*') next = next.filter(node => node.name === name)
    for (const [, condition = ''] of conditions.matchAll(/\[([^\]]*)\]/g)) {
      const wanted = IS_NAME.exec(condition.trim())?.[1]
      const kinds = Array.from(condition.matchAll(SELF), match => match[1])
      if (/^\s*\d{1,9}\s*$/.test(condition)) next = next.slice(Number(condition) - 1, Number(condition))
      else if (wanted !== undefined) next = next.filter(node => node.attributes.get('Name') === wanted)
      else if (kinds.length > 0) next = next.filter(node => kinds.includes(node.name))
      else return null
    }
    found = next
  }
  return found
}

function allBelow(node: XmlNode): XmlNode[] {
  return [node, ...node.children.flatMap(allBelow)]
}
