// Zip archives: their directory, and their files one at a time. fflate inflates. The sizes that an archive states are
// checked before memory is allocated for it.

import { crcOf } from './crc.js';
import { Inflate } from 'fflate';
import { failure } from '../types/errors.js';

/** A file of an archive, as the archive's directory describes it. */
export interface ZipEntry {
  /** With '/' between folders, never leading out of the archive. */
  path: string;
  /** Bytes when unpacked. */
  size: number;
  packedSize: number;
  /** 0: stored, 8: deflated. */
  method: number;
  encrypted: boolean;
  crc: number;
  /** Where the file's own header begins. */
  offset: number;
}

/** A file of an archive, unpacked when it is asked for. */
export interface ZipFile {
  /** With '/' between folders, never leading out of the archive. */
  path: string;
  /** Bytes when unpacked. */
  size: number;
  /** Errors: LIMIT_EXCEEDED, MALFORMED_FILE, UNSUPPORTED_FEATURE. */
  bytes(): Uint8Array<ArrayBuffer>;
}

/** How many more bytes of one archive may be unpacked. */
export interface UnpackBudget {
  left: number;
}

const megabyte = 2 ** 20;
/** Bytes passed to the decoder at a time. Deflate expands them at most 1032 times. */
const portion = 16 * 1024;
const largestRatio = 1032;

/** How much an archive of so many bytes may unpack to. Models do not shrink to less than a 200th. */
export function unpackBudget(archiveSize: number): UnpackBudget {
  return { left: Math.min(1024 * megabyte, Math.max(64 * megabyte, 200 * archiveSize)) };
}

export function isZip(head: Uint8Array): boolean {
  // A file's header, or the end of the directory of an empty archive.
  return (
    head.length >= 4 &&
    head[0] === 0x50 &&
    head[1] === 0x4b &&
    ((head[2] === 3 && head[3] === 4) || (head[2] === 5 && head[3] === 6))
  );
}

function damaged(words: string): Error {
  return failure('MALFORMED_FILE', `the zip is damaged: ${words}`, { hint: 'zip the model again' });
}

/** Reads the archive's numbers, which are little-endian. Throws beyond its end. */
class Numbers {
  readonly #view: DataView;
  constructor(bytes: Uint8Array) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }
  u16(at: number): number {
    this.#check(at, 2);
    return this.#view.getUint16(at, true);
  }
  u32(at: number): number {
    this.#check(at, 4);
    return this.#view.getUint32(at, true);
  }
  u64(at: number): number {
    return this.u32(at) + 2 ** 32 * this.u32(at + 4);
  }
  #check(at: number, length: number): void {
    if (!(at >= 0 && at + length <= this.#view.byteLength)) throw damaged('it ends too early');
  }
}

/**
 * The files of a zip, in its order, without folders, names that lead out of it, and files that operating systems add.
 * Together they unpack to at most 200 times the archive's bytes, at least 64 MB and at most 1 GB. Errors: MALFORMED_FILE.
 */
export function readZip(archive: Uint8Array): ZipFile[] {
  const budget = unpackBudget(archive.length);
  return zipEntries(archive).map((entry) => ({
    path: entry.path,
    size: entry.size,
    bytes: () => unpack(archive, entry, budget),
  }));
}

/**
 * The files of an archive, in the directory's order, without folders, names that are absolute or lead out
 * of the archive, and files that operating systems add. Errors: MALFORMED_FILE.
 */
export function zipEntries(bytes: Uint8Array): ZipEntry[] {
  const numbers = new Numbers(bytes);
  let { count, at } = directoryOf(bytes, numbers);
  const entries: ZipEntry[] = [];
  for (; count > 0; --count) {
    if (numbers.u32(at) !== 0x02014b50) throw damaged('its directory is not where it should be');
    const flags = numbers.u16(at + 8);
    const nameEnd = at + 46 + numbers.u16(at + 28);
    const extraEnd = nameEnd + numbers.u16(at + 30);
    if (extraEnd > bytes.length) throw damaged('it ends too early');
    const wide = [numbers.u32(at + 24), numbers.u32(at + 20), numbers.u32(at + 42)];
    widen(wide, numbers, nameEnd, extraEnd);
    const [size = 0, packedSize = 0, offset = 0] = wide;
    const path = safePath(nameIn(bytes.subarray(at + 46, nameEnd)));
    if (path !== undefined) {
      const [method, encrypted] = [numbers.u16(at + 10), (flags & 1) !== 0];
      entries.push({
        path,
        size,
        packedSize,
        method,
        encrypted,
        crc: numbers.u32(at + 16),
        offset,
      });
    }
    at = extraEnd + numbers.u16(at + 32);
  }
  return entries;
}

/** How many entries the archive's directory has, and where it begins. */
function directoryOf(bytes: Uint8Array, numbers: Numbers): { count: number; at: number } {
  // It ends the file; only a comment of at most 65535 bytes may follow.
  const earliest = Math.max(0, bytes.length - 22 - 0xffff);
  let end = bytes.length - 22;
  while (end >= earliest && numbers.u32(end) !== 0x06054b50) --end;
  if (end < earliest) throw damaged('it has no directory');
  const [count, at] = [numbers.u16(end + 10), numbers.u32(end + 16)];
  const isWide = end >= 20 && numbers.u32(end - 20) === 0x07064b50;
  if (!isWide || (count < 0xffff && at < 0xffffffff)) return { count, at };
  const wideEnd = numbers.u64(end - 12);
  if (numbers.u32(wideEnd) !== 0x06064b50) throw damaged('it has no directory');
  return { count: numbers.u64(wideEnd + 32), at: numbers.u64(wideEnd + 48) };
}

/** Replaces numbers that did not fit into 32 bits by those of 64 bits. */
function widen(wide: number[], numbers: Numbers, from: number, to: number): void {
  for (let at = from; at + 4 <= to; at += 4 + numbers.u16(at + 2)) {
    if (numbers.u16(at) !== 1) continue;
    let next = at + 4;
    wide.forEach((value, i) => {
      if (value !== 0xffffffff || next + 8 > to) return;
      wide[i] = numbers.u64(next);
      next += 8;
    });
    return;
  }
}

/** A name in UTF-8, as in nearly all archives; otherwise in Latin-1. */
function nameIn(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

/** The path with '/' and without '.'; undefined where a model cannot refer to it. */
export function safePath(name: string): string | undefined {
  const parts = name.replaceAll('\\', '/').split('/');
  if (parts[0] === '' || parts.at(-1) === '' || /^[a-z]:/i.test(name)) return undefined;
  const path = parts.filter((part) => part !== '.' && part !== '');
  const isHidden = path.some((part) => part === '..' || part === '__MACOSX' || /^\./.test(part));
  return path.length === 0 || isHidden ? undefined : path.join('/');
}

/**
 * The bytes of a file. Errors: LIMIT_EXCEEDED where it is larger than the budget allows; MALFORMED_FILE
 * where size or checksum are not those of the directory; UNSUPPORTED_FEATURE.
 */
export function unpack(
  archive: Uint8Array,
  entry: ZipEntry,
  budget: UnpackBudget,
): Uint8Array<ArrayBuffer> {
  const { path, size, packedSize, method, offset } = entry;
  if (entry.encrypted || (method !== 0 && method !== 8)) {
    const why = entry.encrypted ? 'encrypted' : `packed by method ${method}`;
    const hint = 'zip the model again, without a password';
    throw failure('UNSUPPORTED_FEATURE', `${path} in the zip is ${why}`, { hint });
  }
  const numbers = new Numbers(archive);
  if (numbers.u32(offset) !== 0x04034b50) throw damaged(`${path} is not where it should be`);
  const from = offset + 30 + numbers.u16(offset + 26) + numbers.u16(offset + 28);
  const packed = archive.subarray(from, from + packedSize);
  if (packed.length < packedSize) throw damaged(`${path} ends too early`);
  // The size is plausible where the budget allows it and the packed bytes can expand to it.
  if (size > budget.left) {
    throw failure('LIMIT_EXCEEDED', `${path} in the zip would unpack to more than is allowed`, {
      hint: 'unpack the zip yourself, and drop the files in it',
    });
  }
  if (size > largestRatio * (packedSize + 1))
    throw damaged(`${path} cannot be as large as it says`);
  budget.left -= size;

  const bytes = new Uint8Array(size);
  let length = 0;
  const take = (part: Uint8Array) => {
    if (length + part.length > size) throw damaged(`${path} is larger than it says`);
    bytes.set(part, length);
    length += part.length;
  };
  if (method === 0) take(packed);
  else {
    const inflate = new Inflate(take);
    try {
      for (let at = 0; at < packedSize; at += portion) {
        inflate.push(packed.subarray(at, at + portion), at + portion >= packedSize);
      }
    } catch (thrown) {
      throw thrown instanceof Error && 'hint' in thrown
        ? thrown
        : damaged(`${path} cannot be unpacked`);
    }
  }
  if (length !== size || crcOf(bytes) !== entry.crc)
    throw damaged(`${path} is not what was zipped`);
  return bytes;
}
