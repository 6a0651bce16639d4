#!/usr/bin/env node
/** `npx hexlens`: the command line in one file, by Node. */
import { main } from '../cli/main'

process.exitCode = await main(process.argv.slice(2))
