// One line about the model.

import type { MeshInfo } from '../src/kernel/index.js';
import { formatCount, make } from '../src/element/index.js';

function plural(count: number, one: string, many: string): string {
  return `${formatCount(count)} ${count === 1 ? one : many}`;
}

/** 'chair.glb', '9,872 faces', 'genus 1', '214 vertices welded': what is not so is left out. */
export function modelFacts(info: MeshInfo): string[] {
  const facts = [info.name, plural(info.faceCount, 'face', 'faces')];
  if (info.components > 1) facts.push(plural(info.components, 'component', 'components'));
  facts.push(`genus ${[...new Set(info.genus)].sort((a, b) => a - b).join(', ')}`);
  if (info.weldedVertices > 0) {
    facts.push(`${plural(info.weldedVertices, 'vertex', 'vertices')} welded`);
  }
  if (info.unreferencedVertices > 0) {
    facts.push(`${plural(info.unreferencedVertices, 'vertex', 'vertices')} without a face dropped`);
  }
  return facts;
}

export function showModel(line: HTMLElement, info: MeshInfo): void {
  const [name = '', ...rest] = modelFacts(info);
  line.replaceChildren(make('b', {}, name), ` · ${rest.join(' · ')}`);
  line.title = line.textContent ?? '';
}
