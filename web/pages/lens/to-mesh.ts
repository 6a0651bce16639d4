/** Beside a list of cells, the way to the page Mesh, with what the list was read from. */
import { html, render, type TemplateResult } from 'lit-html'
import type { PastedInput } from '../../input/pasted-input'
import { handOver } from '../handed-input'

const MESH = './mesh.html'

type List = PastedInput & { readonly cells: number }

export function leadToMesh(lens: HTMLElementTagNameMap['hex-lens']): void {
  const root = document.createElement('div')
  root.slot = 'list'
  root.className = 'to-mesh'

  let given: List | null = null

  async function go(list: List): Promise<void> {
    show(list, 'under-way')
    const isHanded = await handOver(inputOf(list))
    if (given !== list) return
    if (isHanded) location.assign(MESH)
    else show(list, 'refused')
  }

  function show(list: List, state: State): void {
    render(
      template(list, state, () => void go(list)),
      root,
    )
  }

  lens.addEventListener('hex-list', event => {
    given = (event as CustomEvent<List | null>).detail
    if (given === null) return root.remove()
    show(given, 'offered')
    lens.append(root)
  })
  // Back from the other page, the way is there again.
  addEventListener('pageshow', ({ persisted }) => persisted && given && show(given, 'offered'))
}

type State = 'offered' | 'under-way' | 'refused'

function template({ cells }: List, state: State, onPress: () => void): TemplateResult {
  const count = cells.toLocaleString('en')
  const words = {
    offered: html`There: the mesh as a picture, a histogram, and files to take away.`,
    'under-way': html`Handing it over …`,
    refused: html`This browser does not hand it over, perhaps for want of room: drop it on <a href=${MESH}>the page Mesh</a>.`,
  }
  return html`<button type="button" ?disabled=${state === 'under-way'} @click=${onPress}>Open all ${count} cells on the page Mesh</button>
    <p role="status">${words[state]}</p>`
}

function inputOf(list: List): PastedInput {
  return 'text' in list ? { text: list.text } : { files: list.files }
}
