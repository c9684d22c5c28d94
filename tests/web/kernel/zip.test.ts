// Zip archives, honest and otherwise.

import { deflateSync, strToU8, zipSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import {
  isZip,
  safePath,
  unpack,
  unpackBudget,
  zipEntries,
} from '../../../web/src/kernel/unpack/zip.js';

const megabyte = 2 ** 20;
const text = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const unpacked = (archive: Uint8Array, path: string, budget = unpackBudget(archive.length)) =>
  unpack(
    archive,
    zipEntries(archive).find((entry) => entry.path === path)!,
    budget,
  );
const codeOf = (work: () => unknown) => {
  try {
    work();
  } catch (error) {
    return (error as { code?: string }).code;
  }
  return 'nothing was refused';
};

/** A zip as programs write it that do not know a file's size beforehand: the sizes come after it. */
function streamed(path: string, content: Uint8Array): Uint8Array {
  const plain = zipSync({ [path]: content });
  const view = new DataView(plain.buffer, plain.byteOffset, plain.byteLength);
  view.setUint16(6, view.getUint16(6, true) | 8, true);
  for (const at of [14, 18, 22]) view.setUint32(at, 0, true);
  return plain;
}

/** Changes a number of the first file's entry in the directory. */
function tampered(archive: Uint8Array, at: number, value: number): Uint8Array {
  const copy = archive.slice();
  const view = new DataView(copy.buffer);
  let entry = 0;
  while (view.getUint32(entry, true) !== 0x02014b50) ++entry;
  view.setUint32(entry + at, value, true);
  return copy;
}

describe('what is in a zip', () => {
  const archive = zipSync({
    'scene/model.gltf': strToU8('{"asset":{}}'),
    'scene/': new Uint8Array(),
    'scene/buffer.bin': [new Uint8Array(5000).fill(7), { level: 0 }],
    '__MACOSX/scene/._model.gltf': strToU8('x'),
    '.DS_Store': strToU8('x'),
    '../outside.obj': strToU8('x'),
    '/etc/model.obj': strToU8('x'),
    'C:\\model.obj': strToU8('x'),
    'back\\slash.obj': strToU8('x'),
    'größe.obj': strToU8('v 0 0 0'),
  });

  test('is listed without folders, hidden files and names that lead elsewhere', () => {
    expect(isZip(archive)).toBe(true);
    expect(zipEntries(archive).map(({ path }) => path)).toEqual([
      'scene/model.gltf',
      'scene/buffer.bin',
      'back/slash.obj',
      'größe.obj',
    ]);
  });

  test('is unpacked, whether deflated or stored', () => {
    expect(text(unpacked(archive, 'scene/model.gltf'))).toBe('{"asset":{}}');
    expect(unpacked(archive, 'scene/buffer.bin')).toEqual(new Uint8Array(5000).fill(7));
    expect(text(unpacked(archive, 'größe.obj'))).toBe('v 0 0 0');
  });

  test('is found where a comment follows, and where sizes come after the content', () => {
    const content = strToU8('solid '.repeat(1000));
    const other = streamed('a.stl', content);
    const commented = new Uint8Array([...other, ...strToU8('comment')]);
    new DataView(commented.buffer).setUint16(other.length - 2, 7, true);
    expect(unpacked(commented, 'a.stl')).toEqual(content);
  });

  test('paths are those of files', () => {
    expect(safePath('./a//b.bin')).toBe('a/b.bin');
    for (const name of ['', '/', 'a/', '../a', 'a/../b', '/a', '\\a', 'c:/a', '.git/a']) {
      expect(safePath(name)).toBeUndefined();
    }
  });
});

describe('a zip that is not what it says', () => {
  const zeros = new Uint8Array(3 * megabyte);
  const archive = zipSync({ 'zeros.stl': zeros });

  test('cannot unpack to more than the budget', () => {
    const bomb = zipSync({ 'zeros.stl': new Uint8Array(65 * megabyte) });
    expect(bomb.length).toBeLessThan(megabyte);
    expect(codeOf(() => unpacked(bomb, 'zeros.stl'))).toBe('LIMIT_EXCEEDED');
    const budget = { left: 4 * megabyte };
    expect(Buffer.compare(unpacked(archive, 'zeros.stl', budget), zeros)).toBe(0);
    expect(codeOf(() => unpacked(archive, 'zeros.stl', budget))).toBe('LIMIT_EXCEEDED');
  });

  test('is refused where it is larger or smaller than it says, before memory is taken for it', () => {
    const size = 24;
    expect(codeOf(() => unpacked(tampered(archive, size, 1000), 'zeros.stl'))).toBe(
      'MALFORMED_FILE',
    );
    const more = tampered(archive, size, zeros.length + 1);
    expect(codeOf(() => unpacked(more, 'zeros.stl'))).toBe('MALFORMED_FILE');
    const small = zipSync({ 'a.obj': strToU8('v 0 0 0') });
    const claims = tampered(small, size, 60 * megabyte);
    expect(codeOf(() => unpacked(claims, 'a.obj'))).toBe('MALFORMED_FILE');
  });

  test('is refused where its checksum is another, or it is encrypted', () => {
    expect(codeOf(() => unpacked(tampered(archive, 16, 1), 'zeros.stl'))).toBe('MALFORMED_FILE');
    const locked = tampered(archive, 8, 0x0008_0001);
    expect(codeOf(() => unpacked(locked, 'zeros.stl'))).toBe('UNSUPPORTED_FEATURE');
  });

  test('cut off or garbled anywhere, it is an error with a code', () => {
    const whole = zipSync({
      'a/b.obj': strToU8('v 1 2 3\n'.repeat(50)),
      'c.bin': [deflateSync(strToU8('x'.repeat(999))), { level: 0 }],
    });
    const attempt = (bytes: Uint8Array) => {
      if (!isZip(bytes)) return;
      for (const entry of zipEntries(bytes)) unpack(bytes, entry, unpackBudget(bytes.length));
    };
    for (let length = 0; length < whole.length; ++length) {
      expect(['MALFORMED_FILE', 'nothing was refused']).toContain(
        codeOf(() => attempt(whole.slice(0, length))),
      );
    }
    let refused = 0;
    for (let at = 4; at < whole.length; ++at) {
      for (const value of [0, 0xff, whole[at]! ^ 0x10]) {
        const garbled = whole.slice();
        garbled[at] = value;
        const code = codeOf(() => attempt(garbled));
        expect(code).toBeDefined();
        if (code !== 'nothing was refused') ++refused;
      }
    }
    expect(refused).toBeGreaterThan(100);
  });
});
