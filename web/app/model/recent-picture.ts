// A small picture of what the element shows, for the list of recent files.

import type { GirthViewer } from '../../src/element/index.js';

const [width, height] = [144, 108];
/** The width of the picture that the small one is cut out of. */
const wide = 400;
/** Fainter than this is shadow. */
const faint = 60;

/** The surface as large as fits, a PNG without background; undefined where nothing can be drawn. */
export async function recentPicture(viewer: GirthViewer): Promise<Blob | undefined> {
  const options = { width: wide, legend: false, scaleBar: false, transparent: true };
  const whole = await viewer.snapshot(options).then(createImageBitmap);
  const sketch = new OffscreenCanvas(whole.width, whole.height);
  const pen = sketch.getContext('2d', { willReadFrequently: true })!;
  pen.drawImage(whole, 0, 0);
  const { data } = pen.getImageData(0, 0, whole.width, whole.height);
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (let i = 0; 4 * i < data.length; ++i) {
    if (data[4 * i + 3]! < faint) continue;
    const place = [i % whole.width, Math.floor(i / whole.width)];
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k]!, place[k]!);
      high[k] = Math.max(high[k]!, place[k]! + 1);
    }
  }
  const size = [high[0]! - low[0]!, high[1]! - low[1]!] as const;
  if (!(size[0] > 0)) return undefined;
  const scale = Math.min(width / size[0], height / size[1]);
  const picture = new OffscreenCanvas(width, height);
  const [across, down] = [scale * size[0], scale * size[1]];
  const [left, top] = [(width - across) / 2, (height - down) / 2];
  const cut = picture.getContext('2d')!;
  cut.drawImage(sketch, low[0]!, low[1]!, size[0], size[1], left, top, across, down);
  return picture.convertToBlob();
}
