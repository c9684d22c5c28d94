// A model at an address: shown as it is where its file has its values in it, otherwise read by the kernel.

import type { Mesh, Tips } from '../../kernel/types/types.js';
import { figureOf } from './figure-mesh.js';
import { carriedTo } from './given-fields.js';
import type { FileContent } from './file-content.js';
import { nameOf } from '../attributes/parse.js';
import { sharedKernel } from './shared-kernel.js';
import type { Watched } from '../work.js';

/** A mesh, and what else its file has in it. */
export interface Opened {
  mesh: Mesh;
  content: FileContent | undefined;
}

/** The model at an address, without the kernel where that is not needed. */
export async function openModel(address: URL, watched: Watched): Promise<Opened> {
  const bytes = await wholeGlb(address, watched.signal);
  const name = nameOf(address);
  const figure = bytes && (await figureOf(bytes, name, watched.signal));
  if (figure?.mesh) return { mesh: figure.mesh, content: figure.content };
  const kernel = await sharedKernel();
  const mesh = await kernel.load(bytes ? { bytes, name } : address, watched);
  return figure ? withContent(mesh, figure.content) : { mesh, content: undefined };
}

/** The model at an address, read by the kernel, which can compute; with the content of its file. */
export async function openToCompute(
  address: URL,
  content: FileContent,
  watched: Watched,
): Promise<Opened> {
  const kernel = await sharedKernel();
  const mesh = await kernel.load(address, watched);
  return withContent(mesh, content);
}

/** A mesh that the kernel has read, with what its file has for its vertices. */
function withContent(mesh: Mesh, content: FileContent): Opened {
  const { vertexOfInput, info } = mesh;
  const fields = carriedTo(content.fields, vertexOfInput, info.vertexCount);
  return { mesh, content: { ...content, fields, loops: [], tips: undefined, isAll: false } };
}

/** Tips at the vertices of a surface that was made of the one that they are of. */
export function tipsCarriedTo(all: Tips, vertexOfInput: Uint32Array): Tips {
  const tips = all.tips.map((tip) => ({
    ...tip,
    vertices: tip.vertices.map((vertex) => vertexOfInput[vertex]!),
    apex: vertexOfInput[tip.apex]!,
  }));
  return { ...all, tips };
}

/** The bytes of a GLB that has all its parts in it; undefined for anything else, which the kernel explains. */
async function wholeGlb(address: URL, signal: AbortSignal): Promise<ArrayBuffer | undefined> {
  if (!/\.glb$/i.test(address.pathname)) return undefined;
  try {
    const response = await fetch(address, { signal });
    if (!response.ok) return undefined;
    const bytes = await response.arrayBuffer();
    return isWhole(bytes) ? bytes : undefined;
  } catch (error) {
    if (signal.aborted) throw error;
    return undefined;
  }
}

/** Whether bytes are a GLB that names no other file. */
function isWhole(bytes: ArrayBuffer): boolean {
  if (bytes.byteLength < 20) return false;
  const view = new DataView(bytes);
  const length = view.getUint32(12, true);
  if (view.getUint32(0, true) !== 0x46546c67 || length > bytes.byteLength - 20) return false;
  return !new TextDecoder().decode(new Uint8Array(bytes, 20, length)).includes('"uri"');
}
