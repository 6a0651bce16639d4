/** JupyterLab with a notebook whose kernel runs. */
import { type ChildProcess, spawn } from 'node:child_process'
import { createWriteStream } from 'node:fs'
import { createServer } from 'node:net'
import { join } from 'node:path'
import type { APIRequestContext, Page } from '@playwright/test'
import { expect, python } from './host'

export class Lab {
  readonly address: string
  /** What Jupyter says, in a file. */
  readonly log: string
  readonly #process: ChildProcess
  readonly #ended: Promise<unknown>

  private constructor(folder: string, port: number) {
    this.address = `http://127.0.0.1:${port}`
    this.log = join(folder, 'jupyter.log')
    const settings = [
      '--no-browser',
      '--allow-root',
      `--port=${port}`,
      '--ServerApp.port_retries=0',
      '--IdentityProvider.token=',
      '--ServerApp.disable_check_xsrf=True',
      `--ServerApp.root_dir=${folder}`,
      '--LabApp.news_url=None',
      '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate',
    ]
    const log = createWriteStream(this.log)
    this.#process = spawn(join(python, 'jupyter'), ['lab', ...settings], {
      stdio: ['ignore', 'pipe', 'pipe'],
      env: {
        ...process.env,
        JUPYTER_CONFIG_DIR: join(folder, 'config'),
        JUPYTER_RUNTIME_DIR: join(folder, 'runtime'),
        JUPYTER_DATA_DIR: join(folder, 'data'),
        IPYTHONDIR: join(folder, 'ipython'),
      },
    })
    this.#process.stdout?.pipe(log, { end: false })
    this.#process.stderr?.pipe(log, { end: false })
    this.#ended = new Promise(resolve => this.#process.once('exit', resolve))
  }

  static async start(folder: string, request: APIRequestContext): Promise<Lab> {
    const lab = new Lab(folder, await freePort())
    await expect.poll(() => request.get(`${lab.address}/api`).then(asOk, () => false), { timeout: 120_000 }).toBe(true)
    return lab
  }

  async end(): Promise<void> {
    this.#process.kill()
    await this.#ended
  }

  /** Opens a notebook whose kernel was started before the page; one that does not come is replaced, and the page is loaded again. */
  async open(page: Page, notebook: string): Promise<void> {
    await expect(async () => {
      const kernel = await this.#startKernel(page.request, notebook)
      // Without what an earlier page had open.
      await page.goto(`${this.address}/lab/tree/${notebook}?reset`)
      // The server learns of a kernel's state only while somebody listens: from here on JupyterLab does.
      await expect
        .poll(async () => (await (await page.request.get(kernel)).json()).execution_state, { timeout: 60_000 })
        .toBe('idle')
      await expect(page.locator('.jp-Notebook-ExecutionIndicator[data-status="idle"]')).toBeVisible({ timeout: 60_000 })
      await runCell(page, 0, 20_000)
    }).toPass({ timeout: 240_000 })
  }

  /** The address of the only kernel. */
  async #startKernel(request: APIRequestContext, notebook: string): Promise<string> {
    const sessions = `${this.address}/api/sessions`
    for (const { id } of await (await request.get(sessions)).json()) await request.delete(`${sessions}/${id}`)
    const answer = await request.post(sessions, {
      data: { path: notebook, name: notebook, type: 'notebook', kernel: { name: 'python3' } },
    })
    expect(answer.status(), await answer.text()).toBe(201)
    const { kernel } = await answer.json()
    return `${this.address}/api/kernels/${kernel.id}`
  }
}

const asOk = (response: { ok(): boolean }) => response.ok()

export function notebook(cells: readonly string[]): object {
  return {
    nbformat: 4,
    nbformat_minor: 5,
    metadata: { kernelspec: { name: 'python3', display_name: 'Python 3', language: 'python' } },
    cells: cells.map((source, i) => ({
      cell_type: 'code',
      id: `cell-${i}`,
      metadata: {},
      execution_count: null,
      outputs: [],
      source,
    })),
  }
}

export async function runCell(page: Page, index: number, timeout = 120_000): Promise<void> {
  const cell = page.locator('.jp-CodeCell').nth(index)
  await cell.locator('.cm-content').click()
  await page.keyboard.press('Control+Enter')
  await expect(cell.locator('.jp-InputPrompt')).toHaveText(/\[\d+\]:/, { timeout })
}

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const socket = createServer().on('error', reject)
    socket.listen(0, '127.0.0.1', () => {
      const { port } = socket.address() as { port: number }
      socket.close(() => resolve(port))
    })
  })
}
