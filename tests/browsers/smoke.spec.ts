/** The built page in Firefox and in WebKit, by their own pointer and keys: the project names the browser. */
import { test as base, expect } from '@playwright/test'
import { gallery } from '../../web/pages/gallery/gallery'
import { serveWatched } from './watched-page'
import { type BrowserName, type Driver, KEYS, type Point, startBrowser } from './webdriver'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
/** Signs of zero, a subnormal and 17 digits: what a sloppy round trip loses. */
const hard = cube
  .with(0, -0)
  .with(4, 5e-324)
  .with(8, 0.1 + 0.2)
  .with(12, -0)

type HexLens = HTMLElementTagNameMap['hex-lens']

/** The picture that the page shows; null before there is a picture. */
function look(driver: Driver) {
  return driver.run(() => {
    const lens = document.querySelector('hex-lens') as HexLens
    const shadow = lens.shadowRoot
    const frames = Number(shadow?.querySelector<HTMLElement>('.scene')?.dataset.frames ?? 0)
    if (!shadow || frames === 0) return null
    return {
      vertices: lens.vertices,
      verdict: shadow.querySelector('[role=status]')?.textContent?.trim() ?? '',
      alerts: Array.from(shadow.querySelectorAll('[role=alert]'), alert => alert.textContent?.trim()).filter(Boolean),
      frames,
    }
  })
}

const vertices = async (driver: Driver) => (await look(driver))?.vertices

async function expectVerdict(driver: Driver, verdict: RegExp): Promise<void> {
  await expect.poll(async () => (await look(driver))?.verdict, { timeout: 30_000 }).toMatch(verdict)
}

function set(driver: Driver, texts: readonly string[]): Promise<void> {
  return driver.run(given => {
    ;(document.querySelector('hex-lens') as HexLens).vertices = given.map(Number)
  }, texts)
}

/** Signs of zero too: JSON has no -0. */
function bits(driver: Driver): Promise<string[]> {
  return driver.run(() => {
    const { vertices } = document.querySelector('hex-lens') as HexLens
    return Array.from(new BigUint64Array(Float64Array.from(vertices).buffer), String)
  })
}

/** The lines that would stand in the console of the page since it was loaded. */
function complaints(driver: Driver): Promise<string[]> {
  return driver.run(() => (window as unknown as { complaints: string[] }).complaints)
}

/**
 * Chooses a raw VTU on the page of meshes: a lattice with so many cells along each axis, of which `moved` points are moved along x through the
 * opposite faces of four cells each.
 */
function giveLattice(side: number, moved: number): void {
  const [along, count] = [side + 1, side ** 3]
  const index = (x: number, y: number, z: number) => x + along * (y + along * z)
  const points = new Float64Array(3 * along ** 3)
  const cells = new Uint32Array(16 * count)
  const ends = new Uint32Array(2 * count)
  for (let at = 0; at < points.length; at += 3)
    points.set(
      [at / 3, at / 3 / along, at / 3 / along ** 2].map(Math.floor).map(place => place % along),
      at,
    )
  for (let i = 1; i <= moved; ++i) {
    const at = 3 * index(5 * i, 5 * i, 5 * i)
    points[at] = (points[at] as number) + 1.5
  }
  for (let cell = 0; cell < count; ++cell) {
    const [x, y, z] = [cell, cell / side, cell / side ** 2].map(place => Math.floor(place) % side) as [
      number,
      number,
      number,
    ]
    for (let v = 0; v < 8; ++v)
      cells[16 * cell + 2 * v] = index(x + (((v + 1) >> 1) & 1), y + ((v >> 1) & 1), z + (v >> 2))
    ends[2 * cell] = 8 * (cell + 1)
  }
  const lists = [points, cells, ends, new Uint8Array(count).fill(12)]
  let offset = 0
  const [atPoints, atCells, atEnds, atTypes] = lists.map(({ byteLength }) => {
    offset += 8 + byteLength
    return `format="appended" offset="${offset - 8 - byteLength}"/>`
  })
  const head = `<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><UnstructuredGrid>
<Piece NumberOfPoints="${along ** 3}" NumberOfCells="${count}"><Points><DataArray type="Float64" NumberOfComponents="3" ${atPoints}</Points>
<Cells><DataArray type="Int64" Name="connectivity" ${atCells}<DataArray type="Int64" Name="offsets" ${atEnds}
<DataArray type="UInt8" Name="types" ${atTypes}</Cells></Piece></UnstructuredGrid><AppendedData encoding="raw">_`
  const parts = lists.flatMap(list => [Uint32Array.of(list.byteLength, 0), list])
  const transfer = new DataTransfer()
  transfer.items.add(new File([head, ...parts, '</AppendedData></VTKFile>'], 'lattice.vtu'))
  const input = document.querySelector('input[type=file]') as HTMLInputElement
  input.files = transfer.files
  input.dispatchEvent(new Event('change', { bubbles: true }))
}

/** After the frames that follow a change: what is new is laid out, hears of its size, and is drawn. */
async function settled(driver: Driver): Promise<void> {
  await driver.run(() => {
    let frames = 3
    const next = () => {
      Object.assign(window, { isSettled: frames === 0 })
      if (frames-- > 0) requestAnimationFrame(next)
    }
    next()
  })
  await expect.poll(() => driver.run(() => (window as unknown as { isSettled: boolean }).isSettled)).toBe(true)
}

/** The middle of the first element of the shadow tree that has the text, brought into view. */
async function middleOf(driver: Driver, selector: string, text: string): Promise<Point> {
  await settled(driver)
  return driver.run(
    (selector, text) => {
      const { shadowRoot } = document.querySelector('hex-lens') as HexLens
      const all = Array.from((shadowRoot as ShadowRoot).querySelectorAll(selector))
      const found = all.find(element => element.textContent?.trim() === text)
      if (!found) throw new Error(`There is no ${selector} with the text ${text}.`)
      found.scrollIntoView({ block: 'nearest' })
      const box = found.getBoundingClientRect()
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
    },
    selector,
    text,
  )
}

async function click(driver: Driver, button: string): Promise<void> {
  await driver.drag(await middleOf(driver, 'button', button))
}

/** Shares of blue and of red pixels among those that WebGL painted in the frame of a change. */
async function paintedShares(driver: Driver, texts: readonly string[]): Promise<{ blue: number; red: number }> {
  await driver.run(given => {
    const lens = document.querySelector('hex-lens') as HexLens
    const canvas = lens.shadowRoot?.querySelector('canvas') as HTMLCanvasElement
    const size = 100
    const copy = Object.assign(document.createElement('canvas'), { width: size, height: size })
    const context = copy.getContext('2d') as CanvasRenderingContext2D
    lens.vertices = given.map(Number)
    // After the element's own callback of this frame, before the browser shows it: until then the picture can be read.
    requestAnimationFrame(() => {
      context.drawImage(canvas, 0, 0, size, size)
      const { data } = context.getImageData(0, 0, size, size)
      let [painted, blue, red] = [0, 0, 0]
      for (let i = 0; i < data.length; i += 4) {
        const [r, b, alpha] = [data[i] as number, data[i + 2] as number, data[i + 3] as number]
        if (alpha < 250) continue
        painted++
        if (b > r + 40) blue++
        if (r > b + 40) red++
      }
      Object.assign(window, { shares: { blue: blue / painted, red: red / painted } })
    })
  }, texts)
  const shares = () =>
    driver.run(() => (window as unknown as { shares?: { blue: number; red: number } }).shares ?? null)
  await expect.poll(shares).not.toBeNull()
  return (await shares()) as { blue: number; red: number }
}

const bitsOf = (numbers: readonly number[]) => Array.from(new BigUint64Array(Float64Array.from(numbers).buffer), String)

const textsOf = (numbers: readonly number[]) => numbers.map(x => (Object.is(x, -0) ? '-0' : String(x)))

/** Fixtures, because these are taken down also when the test takes too long. */
const test = base.extend<{ address: string; driver: Driver }>({
  address: async ({ baseURL }, use) => {
    const page = await serveWatched(baseURL as string)
    await use(page.url)
    page.close()
  },
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures in it.
  driver: async ({}, use, testInfo) => {
    const driver = await startBrowser(testInfo.project.name as BrowserName, testInfo.outputPath())
    await use(driver)
    await driver.close()
  },
})

test('the page loads, draws, follows pointer and keys, opens its panels, and comes back by its link', async ({
  address,
  driver,
}) => {
  await test.step(`${driver.version} loads it, with a verdict and a picture`, async () => {
    await driver.resize(1200, 780)
    await driver.open(address)
    await expectVerdict(driver, /^INVALID.*min J = −0\.010653/s)
    expect((await look(driver))?.alerts).toEqual([])
  })

  await test.step('WebGL draws the colours of the element', async () => {
    const { blue, red } = await paintedShares(driver, textsOf(cube))
    expect(blue).toBeGreaterThan(0.5)
    expect(red).toBe(0)
  })

  await test.step('a vertex is dragged until the element is invalid, in one step to undo', async () => {
    await expectVerdict(driver, /^VALID/)
    const before = (await look(driver))?.frames as number
    const [from, far] = [await middleOf(driver, '.handle', '6'), await middleOf(driver, '.handle', '0')]
    const towards = (way: number) => ({ x: from.x + way * (far.x - from.x), y: from.y + way * (far.y - from.y) })
    await driver.drag(from, towards(0.3), towards(0.7), towards(1))
    await expectVerdict(driver, /^INVALID/)
    const after = await look(driver)
    expect(after?.vertices.slice(0, 18)).toEqual(cube.slice(0, 18))
    expect(after?.vertices.slice(18, 21)).not.toEqual([1, 1, 1])
    expect(after?.vertices.slice(21)).toEqual(cube.slice(21))
    expect(after?.frames).toBeGreaterThan(before)
    await click(driver, 'Undo')
    await expectVerdict(driver, /^VALID/)
    expect(await vertices(driver)).toEqual(cube)
  })

  await test.step('an arrow key moves the chosen vertex, and is undone', async () => {
    await driver.drag(await middleOf(driver, '.handle', '6'))
    await driver.press(KEYS.ArrowRight)
    await expect.poll(() => vertices(driver)).not.toEqual(cube)
    const moved = (await vertices(driver)) as number[]
    expect(moved.filter((_, i) => i < 18 || i > 20)).toEqual(cube.filter((_, i) => i < 18 || i > 20))
    await click(driver, 'Undo')
    await expect.poll(() => vertices(driver)).toEqual(cube)
  })

  for (const [title, content] of [
    ['Face maps', 'canvas'],
    ['Algorithm 1, step by step', 'ol button'],
    ['Inside', 'canvas'],
    ['Node order', '.answer'],
    ['Morph', 'input[type=range]'],
    ['Paste or drop', 'textarea'],
    ['Take away', 'button'],
  ] as const)
    await test.step(`the panel ${title} is loaded when it is opened`, async () => {
      await click(driver, title)
      const count = () =>
        driver.run(
          (title, content) =>
            (document.querySelector('hex-lens') as HexLens).shadowRoot?.querySelectorAll(
              `[aria-label="${title}"] > div ${content}`,
            ).length,
          title,
          content,
        )
      await expect.poll(count).toBeGreaterThan(0)
    })

  await test.step('a reload shows the same element, bit for bit', async () => {
    const link = () => driver.run(() => location.href)
    const before = await link()
    await set(driver, textsOf(hard))
    await expect.poll(link).not.toBe(before)
    expect(await bits(driver)).toEqual(bitsOf(hard))
    expect(await complaints(driver)).toEqual([])
    await driver.reload()
    await expectVerdict(driver, /VALID/)
    expect(await bits(driver)).toEqual(bitsOf(hard))
    expect(await complaints(driver)).toEqual([])
  })
})

/** The text of the first element of the page, not of the lens, that the selector finds; null if there is none. */
function textOf(driver: Driver, selector: string): Promise<string | null> {
  return driver.run(selector => document.querySelector(selector)?.textContent?.trim() ?? null, selector)
}

function clickOf(driver: Driver, selector: string, text: RegExp): Promise<void> {
  return driver.run(
    (selector, text) => {
      const all = Array.from(document.querySelectorAll<HTMLElement>(selector))
      const found = all.find(element => new RegExp(text).test(element.textContent ?? ''))
      if (!found) throw new Error(`There is no ${selector} with the text ${text}.`)
      found.click()
    },
    selector,
    text.source,
  )
}

test('the pages beside the lens load and answer', async ({ address, driver }) => {
  await driver.resize(1200, 780)

  await test.step('a link opens its lesson, whose claims are judged', async () => {
    await driver.open(`${address}lessons.html#corners-are-not-enough/2`)
    await expectVerdict(driver, /VALID/)
    await expect.poll(() => textOf(driver, '.column h1')).toMatch(/corners/i)
    await expect.poll(() => textOf(driver, '.step[data-active] .claims')).toMatch(/\d/)
    expect(await complaints(driver)).toEqual([])
  })

  await test.step('the lesson in the plane draws its quadrilateral, with the formulas in their font', async () => {
    await driver.open(`${address}lessons.html#quadrilaterals-first/5`)
    await expect.poll(() => textOf(driver, '.plane .verdict')).toMatch(/^INVALID\s+Least J: −3\/4, at corner 2$/)
    const areCornersInside = () =>
      driver.run(() => {
        const pane = document.querySelector('.plane svg.element')?.getBoundingClientRect()
        const dots = Array.from(document.querySelectorAll('.plane .corner .dot'), dot => dot.getBoundingClientRect())
        const places = new Set(dots.map(({ left, top }) => `${Math.round(left)} ${Math.round(top)}`))
        const inside = dots.filter(
          ({ left, right, top, bottom }) =>
            pane && left > pane.left && right < pane.right && top > pane.top && bottom < pane.bottom,
        )
        return [places.size, inside.length]
      })
    await expect.poll(areCornersInside).toEqual([4, 4])
    await expect
      .poll(() => driver.run(() => Array.from(document.fonts as unknown as Iterable<FontFace>, font => font.status)))
      .toEqual(['loaded'])
    expect(await complaints(driver)).toEqual([])
  })

  await test.step('a challenge shows its solution, and that it is one', async () => {
    await driver.open(`${address}challenges.html`)
    await expectVerdict(driver, /VALID/)
    await clickOf(driver, '.challenges a', /./)
    await expect.poll(() => textOf(driver, '.column .goal')).toMatch(/Not met/)
    await clickOf(driver, '.column button', /Show a solution/)
    await expect.poll(() => textOf(driver, '.column .outcome')).toBe('This is the stored solution.')
    expect(await textOf(driver, '.column .goal')).not.toMatch(/Not met/)
    expect(await complaints(driver)).toEqual([])
  })

  await test.step('workers search and find', async () => {
    await driver.open(`${address}search.html?find=edges&seed=11`)
    await expectVerdict(driver, /VALID/)
    await clickOf(driver, '.searching button', /^\s*Start/)
    await expect.poll(() => textOf(driver, '.counts')).toMatch(/; [1-9][\d,]* found$/)
    await clickOf(driver, '.searching button', /^\s*Stop/)
    await expect.poll(() => textOf(driver, '.news')).toMatch(/^Stopped\. /)
    expect(await complaints(driver)).toEqual([])
  })

  await test.step('a mesh of many cells is read by several workers', async () => {
    await driver.open(`${address}mesh.html`)
    await expect.poll(() => textOf(driver, '.headline')).toMatch(/invalid/)
    await driver.run(giveLattice, 48, 5)
    await expect.poll(() => textOf(driver, '.headline')).toMatch(/^20 of 110,592 hexahedra are invalid\./)
    expect(await complaints(driver)).toEqual([])
  })

  await test.step('the gallery has a picture of each of its elements', async () => {
    await driver.open(`${address}gallery.html`)
    const pictures = () =>
      driver.run(() => document.querySelectorAll('.gallery img[src^="data:image/png;base64,"]').length)
    await expect.poll(pictures).toBe(gallery.flatMap(room => room.elements).length)
    expect(await complaints(driver)).toEqual([])
  })
})
