/** The element in the pages of others: its keys, its events, and what they hand it. */
import { expect, handleOf, type Lens, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

interface HostWindow {
  heard: string[]
  told: { name: string; source: string; x: number }[]
  saved: number
}

const host = (lens: Lens) => lens.page.evaluate(() => (globalThis as unknown as HostWindow).heard.splice(0))

test.use({ viewport: { width: 1280, height: 800 } })

test('keys that the element uses go no further, others are untouched', async ({ lens, page }) => {
  await lens.open()
  await lens.preset.selectOption('cube')
  await page.evaluate(() => {
    const heard: string[] = []
    Object.assign(globalThis, { heard, saved: 0 })
    for (const type of ['keydown', 'keypress', 'keyup'])
      addEventListener(type, event => {
        const { key, defaultPrevented } = event as KeyboardEvent
        heard.push(`${type} ${key}${defaultPrevented ? ' prevented' : ''}`)
      })
    // As JupyterLab's shortcuts, which come before the element.
    const onKey = (event: Event) => {
      const { target, key, ctrlKey } = event as KeyboardEvent
      const isSuppressed = (target as Element).hasAttribute('data-lm-suppress-shortcuts')
      if (!isSuppressed) heard.push(`notebook ${ctrlKey ? 'Ctrl+' : ''}${key}`)
      if (ctrlKey && key === 's') event.preventDefault()
    }
    document.addEventListener('keydown', onKey, { capture: true })
  })
  const press = async (keys: readonly string[]) => {
    for (const key of keys) await page.keyboard.press(key)
    return host(lens)
  }

  await test.step('in the scene', async () => {
    await lens.scene.focus()
    expect(await press(['m', 'f', 's', 'x', 'ArrowRight', 'PageDown', '3', '?', '?', 'p', 'Escape'])).toEqual([
      'keydown x',
      'keypress x',
      'keyup x',
    ])
    expect(await press(['Escape'])).toEqual(['keydown Escape', 'keyup Escape'])
    const before = await lens.vertices()
    expect(await press(['Alt+ArrowLeft'])).toContain('keydown ArrowLeft')
    expect(await lens.vertices()).toEqual(before)
    await press(['Control+ArrowLeft'])
    expect(await lens.vertices()).not.toEqual(before)
    expect(await press(['Control+s'])).toContain('notebook Ctrl+s')
    expect(await press(['Control+z'])).not.toContain('keydown z')
  })

  await test.step('in a field, on a button, in a menu', async () => {
    await lens.field(0, 'x').focus()
    expect(await press(['5', 'd', '/', 'Backspace', 'ArrowLeft', 'Escape'])).toEqual([])
    expect(await press(['Escape'])).toEqual(['keydown Escape', 'keyup Escape'])
    await lens.button('Reset').focus()
    expect(await press(['Enter', 'Space'])).toEqual([])
    expect(await press(['n'])).toEqual(['keydown n', 'keypress n', 'keyup n'])
    await lens.preset.focus()
    expect(await press(['ArrowDown', 'ArrowUp'])).toEqual([])
  })

  await test.step('with nothing to undo, and where nothing may be changed', async () => {
    await lens.element.evaluate(element => {
      ;(element as Element).readOnly = true
    })
    await lens.scene.focus()
    expect(await press(['Control+z'])).toContain('keydown z')
    expect(await press(['ArrowLeft'])).toEqual([]) // turns the view
    expect(await press(['PageDown'])).toEqual(['keydown PageDown', 'keyup PageDown'])
  })

  await test.step('once the focus is elsewhere, the notebook has all its keys', async () => {
    await page.evaluate(() => {
      const focused = document.activeElement?.shadowRoot?.activeElement as HTMLElement
      focused.blur()
    })
    expect(await lens.element.evaluate(element => element.hasAttribute('data-lm-suppress-shortcuts'))).toBe(false)
    expect(await press(['x'])).toContain('notebook x')
  })
})

test('numbers that an event brought change nothing when they are given back, at once or late', async ({
  lens,
  page,
}) => {
  await lens.open()
  await lens.preset.selectOption('cube')
  await lens.nextFrame()
  await lens.element.evaluate(element => {
    const lens = element as Element
    const told: HostWindow['told'] = []
    Object.assign(globalThis, { told })
    for (const name of ['hex-input', 'hex-change'] as const)
      lens.addEventListener(name, event => {
        const { vertices, source, valid, boundaryMinimum } = (event as CustomEvent).detail
        if (valid !== lens.report?.valid || boundaryMinimum !== lens.report?.boundaryMinimum) throw new Error(name)
        told.push({ name, source, x: vertices[18] })
        lens.vertices = vertices
        if (lens.history.present > 1) return
        setTimeout(() => (lens.vertices = vertices), 30)
        setTimeout(() => lens.setAttribute('vertices', vertices.join(' ')), 60)
      })
  })
  const { x, y } = await handleOf(lens, 6)
  await page.mouse.move(x, y)
  await page.mouse.down()
  for (let step = 1; step <= 12; step++) {
    await page.mouse.move(x + 5 * step, y + 2 * step)
    await page.waitForTimeout(15)
  }
  await page.waitForTimeout(120)
  const held = await lens.bits()
  await page.mouse.up()
  await page.waitForTimeout(120)
  expect(await lens.bits()).toEqual(held)
  const told = await page.evaluate(() => (globalThis as unknown as HostWindow).told)
  expect(told.length).toBeGreaterThan(3)
  expect(told.filter(({ name }) => name === 'hex-change')).toHaveLength(1)
  expect(new Set(told.map(({ source }) => source))).toEqual(new Set(['pointer']))
  // Neither a jump: the vertex has gone one way alone.
  const way = told.filter(({ name }) => name === 'hex-input').map(({ x }) => x)
  const ways = new Set(way.slice(1).map((x, i) => Math.sign(x - (way[i] as number))))
  expect(ways.size).toBe(1)
  await lens.button('Reset').click()
  await lens.nextFrame()
  expect((await lens.vertices()).slice(18, 21)).toEqual([1, 1, 1])
  await lens.button('Undo').click()
  expect(await lens.bits()).toEqual(held)
  await lens.button('Undo').click()
  expect((await lens.vertices()).slice(18, 21)).toEqual([1, 1, 1])
})

test('what a property may not be is told and changes nothing, and the page goes on', async ({ lens }) => {
  await lens.open()
  const { codes, kept, points } = await lens.element.evaluate(element => {
    const own = element as Element
    const codes: string[] = []
    own.addEventListener('hex-error', event => codes.push((event as CustomEvent).detail.code))
    const before = JSON.stringify([own.vertices, own.preset, own.views, own.history.present])
    const bare = Object.create(null)
    for (const name of ['vertices', 'state', 'history', 'scrollPositions', 'preset', 'camera', 'app'] as const)
      for (const wrong of [7, 'x:y', {}, bare, Symbol('x'), [Number.NaN], () => {}])
        Object.assign(own, { [name]: wrong })
    for (const name of ['vertices', 'state', 'history', 'scrollPositions'] as const)
      for (const wrong of [undefined, null]) Object.assign(own, { [name]: wrong })
    Object.assign(own, { readOnly: undefined, label: Symbol('x') })
    const kept = JSON.stringify([own.vertices, own.preset, own.views, own.history.present]) === before && !own.readOnly
    const told = [...new Set(codes)].sort()
    const points = Array.from({ length: 8 }, (_, v) => new Float32Array([v & 1, (v >> 1) & 1, v >> 2]))
    own.vertices = points
    return { codes: told, kept, points: own.vertices.join() }
  })
  expect(codes).toEqual(
    ['app', 'camera', 'history', 'preset', 'scroll-positions', 'state', 'vertices'].map(name => `bad-${name}`),
  )
  expect(kept).toBe(true)
  expect(points).toBe('0,0,0,1,0,0,0,1,0,1,1,0,0,0,1,1,0,1,0,1,1,1,1,1')
})

test('links lead to the page that is named, and are not there without', async ({ lens, page }) => {
  await lens.open()
  await expect(lens.button('Copy link')).toBeVisible()
  await expect(lens.button('Copy embed')).toBeVisible()
  await lens.element.evaluate(element => element.setAttribute('app', 'https://example.org/hexlens/#x'))
  expect(await lens.element.evaluate(element => (element as Element).permalink)).toMatch(
    /^https:\/\/example\.org\/hexlens\/#v=1&vertices=/,
  )
  await lens.button('Copy embed').click()
  const snippet = page.locator('hex-lens .snippet pre').last()
  await expect(snippet).toContainText('href="https://example.org/hexlens/#v=1')
  await expect(snippet).not.toContainText('app=')
  await page.getByRole('checkbox', { name: 'Presets, undo' }).check()
  await expect(snippet).toContainText('app="https://example.org/hexlens/"')
  await lens.element.first().evaluate(element => element.setAttribute('app', 'javascript:alert(1)'))
  await expect(page.locator('hex-lens .problems').first()).toContainText('is not the address of a page')
  await lens.element.first().evaluate(element => element.removeAttribute('app'))
  await expect(lens.button('Copy link')).toHaveCount(0)
  await expect(lens.button('Copy embed')).toHaveCount(0)
  expect(await lens.element.evaluate(element => (element as Element).permalink)).toBe(null)
})

test('pages can wait for it, focus it and style its states; a picture of what is not displayed is refused', async ({
  lens,
  page,
}) => {
  await lens.open()
  const told = await page.evaluate(async () => {
    const own = document.createElement('hex-lens')
    own.autofocus = true
    own.style.cssText = 'display: block; width: 400px; height: 300px'
    let events = 0
    own.addEventListener('hex-ready', () => events++)
    const before = own.matches(':state(ready), :state(valid), :state(invalid)')
    ;(document.activeElement as HTMLElement | null)?.blur()
    document.querySelector('main')?.prepend(own)
    await own.ready
    const states = () => ['ready', 'valid', 'invalid'].filter(state => own.matches(`:state(${state})`))
    const drawn = [events, states(), document.activeElement === own]
    own.preset = 'cube'
    await new Promise(requestAnimationFrame)
    const valid = states()
    own.hidden = true
    own.style.display = 'none'
    const refusal = (promise: Promise<unknown>) => promise.then(String, error => error.code)
    const hidden = [await refusal(own.toPNG()), await refusal(own.toSVG())]
    const unseen = document.createElement('hex-lens')
    hidden.push(await refusal(unseen.toPNG()))
    own.hidden = false
    own.style.display = 'block'
    const pending = own.toPNG()
    const { type } = await pending
    own.remove()
    const gone = states()
    unseen.focus()
    document.querySelector('main')?.append(unseen)
    return { before, drawn, valid, hidden, type, gone }
  })
  expect(told).toEqual({
    before: false,
    drawn: [1, ['ready', 'invalid'], true],
    valid: ['ready', 'valid'],
    hidden: ['no-picture', 'no-picture', 'no-picture'],
    type: 'image/png',
    gone: ['valid'],
  })
  await page.getByRole('button', { name: 'Reset' }).first().focus()
  await lens.element.first().evaluate(element => (element as HTMLElement).focus())
  await expect(lens.scene.first()).toBeFocused()
})
