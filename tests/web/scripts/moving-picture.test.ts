// README's moving picture, and the file format that it is written in.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { animatedWebp } from '../../../web/scripts/animated-webp.mjs';
import { repository } from '../../../web/scripts/run.mjs';

/** The chunks of a RIFF file: name and content. */
function chunksOf(file: Buffer): [name: string, content: Buffer][] {
  expect(file.toString('latin1', 0, 4)).toBe('RIFF');
  expect(file.readUInt32LE(4)).toBe(file.length - 8);
  expect(file.toString('latin1', 8, 12)).toBe('WEBP');
  const chunks: [string, Buffer][] = [];
  for (let at = 12; at < file.length;) {
    const length = file.readUInt32LE(at + 4);
    chunks.push([file.toString('latin1', at, at + 4), file.subarray(at + 8, at + 8 + length)]);
    at += 8 + length + (length % 2);
  }
  return chunks;
}

/** A picture of WebP, as far as the container knows: chunks of these bytes. */
function still(...chunks: [name: string, content: number[]][]): Buffer {
  const body = chunks.map(([name, content]) => {
    const head = Buffer.from(`${name}\0\0\0\0`, 'latin1');
    head.writeUInt32LE(content.length, 4);
    return Buffer.concat([head, Buffer.from(content), Buffer.alloc(content.length % 2)]);
  });
  return Buffer.concat([Buffer.from('RIFF\0\0\0\0WEBP', 'latin1'), ...body]);
}

test('a moving picture has its stills as they are, with their size and time', () => {
  const options = { width: 480, height: 300, milliseconds: 1000 };
  const file = animatedWebp(
    [still(['VP8X', [9]], ['VP8 ', [1, 2, 3]]), still(['VP8 ', [4, 5]])],
    options,
  );
  const chunks = chunksOf(file);
  expect(chunks.map(([name]) => name)).toEqual(['VP8X', 'ANIM', 'ANMF', 'ANMF']);
  expect([...chunks[0]![1]]).toEqual([2, 0, 0, 0, 0xdf, 1, 0, 0x2b, 1, 0]);
  const [, first] = chunks[2]!;
  expect([...first.subarray(0, 16)]).toEqual([
    ...[0, 0, 0, 0, 0, 0],
    ...[0xdf, 1, 0, 0x2b, 1, 0],
    ...[0xe8, 3, 0, 0],
  ]);
  expect(first.subarray(16)).toEqual(still(['VP8 ', [1, 2, 3]]).subarray(12));
});

test('a picture that one sees through is refused', () => {
  const options = { width: 1, height: 1, milliseconds: 1 };
  for (const seen of [still(['VP8L', [1]]), still(['ALPH', [1]], ['VP8 ', [1]]), still()]) {
    expect(() => animatedWebp([seen], options)).toThrow('not an opaque WebP');
  }
});

test('README’s picture moves, and has at most 300 kB', () => {
  const file = readFileSync(join(repository, 'web/docs/images/moving.webp'));
  expect(file.length).toBeLessThanOrEqual(300_000);
  expect(chunksOf(file).filter(([name]) => name === 'ANMF').length).toBeGreaterThanOrEqual(20);
});
