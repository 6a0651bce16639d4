/** Pastes or drops a text or files, as a reader does. */
import type { Locator, Page } from '@playwright/test'

/** The clipboard must be granted. */
export async function pasteAnywhere(page: Page, text: string): Promise<void> {
  await page.evaluate(given => navigator.clipboard.writeText(given), text)
  await page.keyboard.press('Control+V')
}

export interface DroppedFile {
  readonly name: string
  readonly bytes: Buffer
}

/** Drags files or a text from elsewhere onto the target. */
export async function drop(
  target: Locator,
  content: { readonly text: string } | { readonly files: readonly DroppedFile[] },
): Promise<void> {
  const given =
    'text' in content
      ? content
      : { files: content.files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') })) }
  const transfer = await target.page().evaluateHandle(dragged => {
    const data = new DataTransfer()
    if ('text' in dragged) data.setData('text/plain', dragged.text)
    else
      for (const { name, base64 } of dragged.files)
        data.items.add(new File([Uint8Array.from(atob(base64), character => character.charCodeAt(0))], name))
    return data
  }, given)
  for (const type of ['dragover', 'drop']) await target.dispatchEvent(type, { dataTransfer: transfer })
}
