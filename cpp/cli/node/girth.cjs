#!/usr/bin/env node
// girth, the command, without a compiler: starts its WebAssembly module, which ends the process with its exit code.
// CommonJS, which Node.js starts sooner than modules.

const { readFileSync } = require('node:fs');
const process = require('node:process');
const createGirthCommand = require('./girth-command.js');

createGirthCommand({
  wasmBinary: readFileSync(require.resolve('./girth-command.wasm')),
  arguments: process.argv.slice(2),
});
