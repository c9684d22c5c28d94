// Arrays as a page carries them: compressed by gzip, in Base64.

/** Bytes of an array, little-endian. */
export type Packed = string;

/** The bytes of an array. */
export async function unpacked(text: Packed): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(plain).arrayBuffer();
}
