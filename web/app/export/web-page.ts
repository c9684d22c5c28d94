// The model as a web page in one file, with its values and pinned loops: it needs no server and computes nothing.

import {
  type CombinedName,
  type GirthViewer,
  type GivenName,
  type ViewerState,
  fieldTitle,
  isFieldName,
} from '../../src/element/index.js';
import type { Field } from '../../src/kernel/index.js';

/** Attributes that a page without a kernel can show. */
const shownAttributes = [
  ...(['colormap', 'range', 'log', 'isolines', 'edges', 'shading', 'up', 'section'] as const),
  ...(['camera', 'pins', 'shown-unit'] as const),
] satisfies readonly (keyof ViewerState)[];

/** The name that a saved page has for values that are no field: it has no unit. */
const anyValues = 'sihks';

const escaped = (text: string): string =>
  text.replace(/[&"<>]/g, (letter) => `&#${letter.charCodeAt(0)};`);

/** An array as pages carry it (`packed.ts`). */
async function packed(array: ArrayBufferView<ArrayBuffer>): Promise<string> {
  const plain = new Blob([array]).stream().pipeThrough(new CompressionStream('gzip'));
  const bytes = new Uint8Array(await new Response(plain).arrayBuffer());
  let text = '';
  // More arguments at a time would not fit on the stack.
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text);
}

/** The field that colours the surface, with its title; values that no field has are written as any values. */
async function shownField(
  viewer: GirthViewer,
): Promise<{ field: Pick<Field, 'name' | 'values' | 'kinds' | 'method' | 'unit'>; title: string }> {
  const name = viewer.shown?.name ?? 'igf';
  const title = viewer.getAttribute('field-title') ?? '';
  const isGirth = ['kind', 'state', 'tips', 'parts'].includes(name);
  if (isGirth || isFieldName(name)) {
    return { field: await viewer.fieldOf(isFieldName(name) ? name : 'igf'), title };
  }
  return {
    field: {
      ...{
        name: anyValues,
        values: viewer.values(name as CombinedName | GivenName),
        kinds: new Uint8Array(0),
      },
      ...{ method: '', unit: '' },
    },
    title: title || fieldTitle(name),
  };
}

const textAt = async (address: URL): Promise<string> => (await fetch(address)).text();

/** The page, which shows what the viewer shows; a field that colours the surface is computed to its end first. */
export async function webPage(viewer: GirthViewer): Promise<string> {
  const [program, template] = await Promise.all([
    textAt(new URL('../../../build/shown/girth-shown.js', import.meta.url)),
    textAt(new URL('../../src/element/saved-page.html.in', import.meta.url)),
  ]);
  const mesh = await viewer.mesh;
  const { positions, indices, boundary, origin } = mesh.geometry;
  const { name, size, area } = mesh.info;
  const unit = mesh.info.unit || viewer.unit;
  const { state } = viewer;
  const isColoured = state.field !== 'none';
  const { field, title } = isColoured ? await shownField(viewer) : { field: undefined, title: '' };
  const content = {
    ...{ name, unit, origin, size, area },
    positions: await packed(new Float32Array(positions)),
    indices: await packed(new Uint32Array(indices)),
    boundary: await packed(new Uint32Array(boundary)),
    areas: await packed(new Float64Array(await viewer.areas())),
    rows: null,
    field: field && {
      ...{ name: field.name, unit: field.unit, method: field.method },
      values: await packed(new Float64Array(field.values)),
      kinds: await packed(new Uint8Array(field.kinds)),
    },
    loops: await Promise.all(
      viewer.pinned.map(async ({ loop }) => ({
        ...loop,
        points: [],
        polyline: await packed(new Float32Array(loop.polyline)),
      })),
    ),
    points: [],
  };
  const attributes: [string, string][] = [
    ['field', field?.name ?? 'none'],
    ['loop', 'none'],
    ['controls', 'true'],
    ...(title ? [['field-title', title] as [string, string]] : []),
  ];
  for (const key of shownAttributes) {
    const value = state[key];
    if (value !== undefined) attributes.push([key, String(value)]);
  }
  const parts: Readonly<Record<string, string>> = {
    title: escaped(name || 'Girth'),
    attributes: attributes.map(([key, value]) => `${key}="${escaped(value)}"`).join(' '),
    // The end of a script in HTML is written otherwise in JSON and in JavaScript.
    content: JSON.stringify(content).replace(/</g, '\\u003c'),
    program: program.replace(/<\/script/g, '<\\/script'),
  };
  return template.replace(/\{\{(\w+)\}\}/g, (_, part: string) => parts[part] ?? '');
}
