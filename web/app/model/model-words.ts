// A model and what was done to it, in words.

import type { MeshInfo, PreparationReport } from '../../src/kernel/index.js';
import {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
} from '../../src/element/index.js';

export function plural(count: number, one: string, many: string): string {
  return `${formatCount(count)} ${count === 1 ? one : many}`;
}

const sum = (numbers: readonly number[]): number => numbers.reduce((a, b) => a + b, 0);

/** 'chair.glb', '9,872 faces', 'genus 1', '2 holes': facts that do not hold are left out. */
export function modelFacts(info: MeshInfo): string[] {
  const facts = [info.name, plural(info.faceCount, 'face', 'faces')];
  if (info.components > 1) facts.push(plural(info.components, 'component', 'components'));
  const genus = [...new Set(info.genus)].sort((a, b) => a - b);
  facts.push(genus.length < 4 ? `genus ${genus.join(', ')}` : `genus 0 to ${genus.at(-1)}`);
  const open = sum(info.boundaries);
  if (open > 0) facts.push(plural(open, 'open boundary', 'open boundaries'));
  return facts;
}

/** '1.20 × 3.40 × 0.50 m'. */
export function sizeWords({ size }: MeshInfo, format: LengthFormat): string {
  const largest = Math.max(...size);
  const words = size.map((extent) => formatNumber(extent, format));
  return largest > 0
    ? `${words.slice(0, 2).join(' × ')} × ${formatLength(size[2], format)}`
    : formatLength(0, format);
}

/** The repairs of the input, a line for each step that did anything; lengths in `format`. */
export function repairs(report: PreparationReport, format: LengthFormat): string[] {
  const lines: string[] = [];
  const say = (count: number, one: string, many: string, what: string): void => {
    if (count > 0) lines.push(`${plural(count, one, many)} ${what}`);
  };
  const vertices = ['vertex', 'vertices'] as const;
  const faces = ['face', 'faces'] as const;
  const edges = ['edge', 'edges'] as const;
  say(report.weldedVertices, ...vertices, 'welded onto others at the same place');
  say(report.degenerateFaces, ...faces, 'without area dropped');
  say(
    report.addedFaces,
    ...faces,
    'made by dividing others, where neighbours have a vertex within their edge',
  );
  say(report.flippedFaces, ...faces, 'without area kept, their long edge flipped');
  say(report.duplicateFaces, ...faces, 'dropped that were there twice');
  say(report.unreferencedVertices, ...vertices, 'without a face dropped');
  say(report.reorientedFaces, ...faces, 'turned over, to face the same way as their neighbours');
  say(report.oneSidedEdges, ...edges, 'cut, as the surface has one side only');
  say(report.nonManifoldEdges, ...edges, 'cut where more than two faces meet');
  say(report.nonManifoldVertices, ...vertices, 'cut where parts only touch');
  say(report.addedVertices, ...vertices, 'made by cutting');
  say(report.crackVertices, ...vertices, 'at cracks, next to another one on the boundary');
  say(report.tJunctions, ...vertices, 'at cracks, within the edge of a neighbour');
  if (report.crackWidth > 0) {
    // Two digits, however small: a crack may be as wide as a rounding.
    const decimals = Math.max(0, 1 - Math.floor(Math.log10(report.crackWidth * format.scale)));
    const width = formatLength(report.crackWidth, { ...format, decimals });
    lines.push(`a weld distance of ${width} closes the cracks`);
  }
  const components = ['component', 'components'] as const;
  say(report.sliverComponents, ...components, 'of less than a millionth of the largest one’s area');
  say(report.doubledComponents, ...components, 'with nothing inside: two sheets on each other');
  if (report.keptComponents < report.components) {
    lines.push(
      `${formatCount(report.keptComponents)} of ${formatCount(report.components)} components kept`,
    );
  }
  for (const { edges, perimeter } of report.holes.slice(0, 6)) {
    const round = formatLength(perimeter, format);
    lines.push(`a hole of ${formatCount(edges)} edges closed, length of its boundary ${round}`);
  }
  const others = report.closedHoles - Math.min(6, report.holes.length);
  say(others, 'other hole', 'other holes', 'closed');
  return lines;
}
