// Still WebP pictures in, one moving picture out: https://developers.google.com/speed/webp/docs/riff_container

/** @param {number} value */
const in24bits = (value) => [value & 0xff, (value >> 8) & 0xff, (value >> 16) & 0xff];

/**
 * A chunk of RIFF: name, length, content, and a byte more where the length is odd.
 * @param {string} name
 * @param {Uint8Array} content
 */
function chunk(name, content) {
  const head = Buffer.alloc(8);
  head.write(name, 'latin1');
  head.writeUInt32LE(content.length, 4);
  return Buffer.concat([head, content, Buffer.alloc(content.length % 2)]);
}

/**
 * The chunk with the picture itself: a lossy bitstream, `VP8 `. Profiles and the like are left out.
 * @param {Uint8Array} picture an opaque picture, a file of WebP
 */
function bitstreamOf(picture) {
  const file = Buffer.from(picture);
  for (let at = 12; at < file.length;) {
    const name = file.toString('latin1', at, at + 4);
    const length = file.readUInt32LE(at + 4);
    const end = at + 8 + length + (length % 2);
    if (name === 'VP8 ') return file.subarray(at, end);
    if (name === 'ALPH' || name === 'VP8L') break;
    at = end;
  }
  throw new Error('not an opaque WebP');
}

/**
 * A moving picture that repeats without end.
 * @param {Uint8Array[]} pictures opaque pictures of the given size, files of WebP
 * @param {{ width: number, height: number, milliseconds: number }} options pixels, and how long each picture is shown
 */
export function animatedWebp(pictures, { width, height, milliseconds }) {
  const size = [...in24bits(width - 1), ...in24bits(height - 1)];
  const place = [0, 0, 0, 0, 0, 0];
  const head = Uint8Array.from([...place, ...size, ...in24bits(milliseconds), 0]);
  const frames = pictures.map((picture) =>
    chunk('ANMF', Buffer.concat([head, bitstreamOf(picture)])),
  );
  const animated = 0x02;
  const body = Buffer.concat([
    Buffer.from('WEBP', 'latin1'),
    chunk('VP8X', Uint8Array.from([animated, 0, 0, 0, ...size])),
    // White behind the pictures, and repeated without end.
    chunk('ANIM', Uint8Array.from([255, 255, 255, 255, 0, 0])),
    ...frames,
  ]);
  return chunk('RIFF', body);
}
