// Which of several files are models, and what belongs to them.

import { strToU8, zipSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import { FileSet, looksLikeModel, type SetFile } from '../../../web/src/kernel/unpack/file-set.js';

const file = (path: string, content: string | Uint8Array = 'x'): SetFile => {
  const bytes = typeof content === 'string' ? strToU8(content) : content;
  return { path, size: bytes.length, bytes: () => new Uint8Array(bytes) };
};
const models = (...files: SetFile[]) => new FileSet(files).models;
const textOf = (found: SetFile | undefined) => found && new TextDecoder().decode(found.bytes());

function refusal(work: () => unknown) {
  try {
    work();
  } catch (error) {
    return error as { code: string; message: string; hint: string };
  }
  throw new Error('nothing was refused');
}

describe('the models among files', () => {
  test('by their names: those outside of folders first, numbers in their order', () => {
    const files = ['b/a.glb', 'part10.stl', 'part9.STL', 'image.png', 'data.bin', 'b/c/d.obj'];
    expect(models(...files.map((path) => file(path)))).toEqual([
      'part9.STL',
      'part10.stl',
      'b/a.glb',
      'b/c/d.obj',
    ]);
  });

  test('by their content where no name says so', () => {
    const found = models(file('readme'), file('scan', 'ply\nformat ascii 1.0\n'), file('a.png'));
    expect(found).toEqual(['scan']);
    for (const head of ['glTF\x02', 'OFF\n1', 'COFF 1', 'STOFF\n', 'solid a', ' {"asset"']) {
      expect(looksLikeModel(strToU8(head))).toBe(true);
    }
    for (const head of ['', 'PK', '\x89PNG', 'hello', 'OFFICE']) {
      expect(looksLikeModel(strToU8(head))).toBe(false);
    }
  });

  test('a file by itself is for the reader to judge, whatever its name', () => {
    expect(models(file('letter.docx'))).toEqual(['letter.docx']);
    expect(models(file('model'))).toEqual(['model']);
  });

  test('where none is one that is read, the largest that may be another is for the reader to name', () => {
    const found = models(
      file(
        'scene.zip',
        zipSync({ 'a.png': new Uint8Array(99), 'part.step': strToU8('ISO-10303-21;') }),
      ),
    );
    expect(found).toEqual(['part.step']);
    expect(models(file('readme'), file('a.blend', 'BLENDER-v300'))).toEqual(['a.blend']);
  });

  test('none at all is said in words', () => {
    const none = refusal(() => models(file('a.png'), file('b.txt')));
    expect(none.code).toBe('UNKNOWN_FORMAT');
    expect(none.message).toBe('none of the 2 files is a model');
    const empty = refusal(() => models(file('a.zip', zipSync({}))));
    expect(empty.message).toBe('there is no file in a.zip');
    const picture = refusal(() => models(file('a.zip', zipSync({ 'b.png': strToU8('x') }))));
    expect(picture.message).toBe('b.png is no model');
  });

  test('a model is asked for by its path', () => {
    const set = new FileSet([file('a.obj', 'a'), file('b.obj', 'b')]);
    expect(textOf(set.model('b.obj'))).toBe('b');
    const { code, hint } = refusal(() => set.model('c.obj'));
    expect(code).toBe('FILE_NOT_FOUND');
    expect(hint).toContain('a.obj, b.obj');
  });
});

describe('zips', () => {
  const zip = (files: Record<string, string>) =>
    zipSync(Object.fromEntries(Object.entries(files).map(([path, text]) => [path, strToU8(text)])));

  test('are replaced by what is in them, whatever the name', () => {
    const archive = zip({ 'duck/duck.gltf': '{}', 'duck/duck.bin': 'bytes' });
    for (const name of ['duck.zip', 'download']) {
      const set = new FileSet([file(name, archive)]);
      expect(set.models).toEqual(['duck/duck.gltf']);
      expect(textOf(set.resource('duck/duck.gltf', 'duck.bin'))).toBe('bytes');
    }
  });

  test('beside other files keep apart what is in them', () => {
    const set = new FileSet([
      file('a.zip', zip({ 'm.gltf': '{}', 'm.bin': 'a' })),
      file('b.zip', zip({ 'm.gltf': '{}', 'm.bin': 'b' })),
    ]);
    expect(set.models).toEqual(['a.zip/m.gltf', 'b.zip/m.gltf']);
    expect(textOf(set.resource('b.zip/m.gltf', 'm.bin'))).toBe('b');
  });

  test('a file that only calls itself a zip is for the reader to judge', () => {
    expect(models(file('a.zip', 'v 0 0 0'))).toEqual(['a.zip']);
  });
});

describe('what a model refers to', () => {
  const set = new FileSet([
    file('one/model.gltf'),
    file('one/Buffer.bin', 'one'),
    file('one/sub/deep.bin', 'deep'),
    file('two/model.gltf'),
    file('two/buffer.bin', 'two'),
  ]);

  test('lies beside it or below, in any case of letters', () => {
    expect(textOf(set.resource('one/model.gltf', 'buffer.bin'))).toBe('one');
    expect(textOf(set.resource('two/model.gltf', './buffer.bin'))).toBe('two');
    expect(textOf(set.resource('one/model.gltf', 'sub/deep.bin'))).toBe('deep');
    expect(set.resource('two/model.gltf', 'sub/deep.bin')).toBeUndefined();
  });

  test('never lies elsewhere', () => {
    for (const name of ['../two/buffer.bin', '/two/buffer.bin', 'a/../../two/buffer.bin', '']) {
      expect(set.resource('one/model.gltf', name)).toBeUndefined();
    }
  });

  test('is found by its last name among files without folders', () => {
    const flat = new FileSet([file('model.gltf'), file('buffer.bin', 'flat')]);
    expect(textOf(flat.resource('model.gltf', 'buffers/buffer.bin'))).toBe('flat');
  });
});
