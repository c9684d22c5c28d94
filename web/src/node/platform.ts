// Services of Node.js that a kernel asks for.

import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { basename } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { failure, fieldsOf } from '../kernel/types/errors.js';
import type { Platform } from '../kernel/page/platform.js';
import { fetched, type ContentAt } from '../kernel/page/source.js';

export const node: Platform = {
  sharesMemory: true,
  cores: availableParallelism(),
  contentAt: (address, signal) =>
    /^(https?|data|blob):/i.test(address) ? fetched(address, signal) : fileAt(address, signal),
};

/** The file of a path or an address of the scheme `file`. */
const fileAt: ContentAt = async (name, signal) => {
  try {
    const path = /^file:/i.test(name) ? fileURLToPath(name) : name;
    const content = new Blob([await readFile(path, { signal })]);
    return { files: [{ path: basename(path), content }], address: pathToFileURL(path).href };
  } catch (cause) {
    const { code = '' } = cause as NodeJS.ErrnoException;
    if (/^(ENOENT|ENOTDIR)$/.test(code)) {
      throw failure('FILE_NOT_FOUND', `there is no file ${name}`, { cause });
    }
    const { message } = fieldsOf(cause);
    throw failure('FILE_UNREADABLE', `${name} cannot be read: ${message}`, { cause });
  }
};
