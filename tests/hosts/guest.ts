/** What a good guest does in any host. */
import type { Lens } from '../e2e/lens'
import { documented } from '../unit/embed-fixture'
import { expect } from './host'

export async function expectDocumented(lens: Lens, address: string): Promise<void> {
  await lens.open(address)
  await expect(lens.verdict).toHaveText(/^INVALID/)
  expect(await lens.vertices()).toEqual(documented.vertices)
  await expect(lens.page.getByRole('group', { name: documented.label })).toBeVisible()
}
