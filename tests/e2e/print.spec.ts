import { expect, test } from './lens'
import { readPdf } from './pdf'

test.use({ colorScheme: 'dark' })

test('on paper: black on white, what is open at its full length, nothing to press', async ({ lens, page }) => {
  await lens.open()
  await lens.scene.press('+')
  for (const panel of ['Face maps', 'Algorithm 1, step by step', 'Take away']) await lens.button(panel).click()
  await expect(page.getByRole('list', { name: 'All steps' }).getByRole('listitem')).toHaveCount(26)
  await expect(lens.button('Copy BibTeX')).toBeVisible()
  const handle = page.locator('hex-lens .scene-overlay .handle').first()
  const onScreen = await handle.getAttribute('transform')

  const { pages, pictures } = readPdf(await page.pdf({ format: 'A4' }))
  const text = pages.join('\n')
  for (const words of [
    'INVALID',
    'min J = −0.010653',
    '(−0.20455, −0.10227, 0.14773)',
    'Who would notice?',
    'Twelve edges',
    'Vertices',
    'Quartic of face −ξ',
    'Face +ζ',
  ])
    expect(text).toContain(words)
  for (const word of ['Undo', 'Copy', 'Fit', 'Help', 'Show the proof', 'Take away', 'Point at', 'Forward'])
    expect(text).not.toContain(word)
  // The scene's picture at three device pixels to a CSS pixel.
  expect(pictures).toContainEqual([1920, 1440])
  expect(pages.length).toBeLessThan(7)
  expect(pages.every(page => page.trim() !== '')).toBe(true)

  await expect(lens.element).not.toHaveAttribute('data-printing')
  await expect.poll(() => handle.getAttribute('transform')).toBe(onScreen)

  await page.setViewportSize({ width: 688, height: 900 })
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('hex-lens canvas.for-paper')).toBeAttached()
  const seen = await lens.element.evaluate(element => {
    const { color, backgroundColor } = getComputedStyle(element.shadowRoot?.querySelector('.lens') as Element)
    const copy = element.shadowRoot?.querySelector<HTMLCanvasElement>('canvas.for-paper') as HTMLCanvasElement
    const pixels = copy.getContext('2d')?.getImageData(0, 0, copy.width, copy.height).data ?? []
    let blue = 0
    for (let i = 0; i < pixels.length; i += 4) if ((pixels[i + 2] as number) > (pixels[i] as number) + 40) blue++
    const { scrollWidth, clientWidth } = document.documentElement
    return { color, backgroundColor, blueShare: blue / (pixels.length / 4), overflow: scrollWidth - clientWidth }
  })
  expect(seen).toMatchObject({ color: 'rgb(0, 0, 0)', backgroundColor: 'rgb(255, 255, 255)', overflow: 0 })
  expect(seen.blueShare).toBeGreaterThan(0.1)
})
