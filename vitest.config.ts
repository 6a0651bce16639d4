import { defineConfig } from 'vitest/config'

export default defineConfig({
  test: {
    include: ['tests/**/*.test.ts'],
    environment: 'node',
    setupFiles: ['tests/unit/equal-numbers.ts'],
    // Guards against hanging, not measurements: machines may be slow and busy.
    testTimeout: 120_000,
    hookTimeout: 120_000,
    allowOnly: false,
    // Node 20 may crash when a thread is ended while code of its is still being optimized in the background.
    execArgv: ['--no-concurrent-recompilation'],
    // Of two cores vitest would leave one idle.
    maxWorkers: '100%',
    // One process for all files of a worker: to start one for each, and to load the modules anew, takes as long as half of the files.
    isolate: false,
    unstubGlobals: true,
  },
})
