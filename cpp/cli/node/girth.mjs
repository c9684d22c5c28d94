#!/usr/bin/env node
// girth, the command, without a compiler: starts its WebAssembly module, which ends the process with its exit code.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const createGirthCommand = createRequire(import.meta.url)('./girth-command.js');
await createGirthCommand({
  wasmBinary: readFileSync(new URL('girth-command.wasm', import.meta.url)),
  arguments: process.argv.slice(2),
});
