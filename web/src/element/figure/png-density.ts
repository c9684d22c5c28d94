// How large a PNG is meant to be printed: its pHYs chunk (PNG specification, section 11.3.4.3).

import { crcOf } from '../../kernel/unpack/crc.js';

/** Bytes of the signature and the first chunk, which is always the header. */
const headLength = 8 + 25;
const inchesPerMetre = 1 / 0.0254;

/** A copy of a picture with so many pixels for each inch. */
export async function withDensity(png: Blob, dotsPerInch: number): Promise<Blob> {
  const chunk = new Uint8Array(21);
  const numbers = new DataView(chunk.buffer);
  const perMetre = Math.round(dotsPerInch * inchesPerMetre);
  numbers.setUint32(0, 9);
  chunk.set(new TextEncoder().encode('pHYs'), 4);
  numbers.setUint32(8, perMetre);
  numbers.setUint32(12, perMetre);
  chunk[16] = 1;
  numbers.setUint32(17, crcOf(chunk.subarray(4, 17)));
  const bytes = new Uint8Array(await png.arrayBuffer());
  return new Blob([bytes.subarray(0, headLength), chunk, bytes.subarray(headLength)], {
    type: 'image/png',
  });
}
