// `<girth-viewer>`, defined as soon as this module is imported, and what a page around it needs.

import { GirthViewer } from './viewer-element.js';

if (!customElements.get('girth-viewer')) customElements.define('girth-viewer', GirthViewer);

declare global {
  interface HTMLElementTagNameMap {
    'girth-viewer': GirthViewer;
  }
}

export { GirthViewer };
export type { FieldDetail, LoadDetail, ProgressDetail } from './viewer-element.js';
export type { PickDetail, PinnedLoop } from './loops-on-surface.js';
export { make } from './dom.js';
export { useKernel } from './shared-kernel.js';
export {
  type CameraView,
  type ColormapName,
  type Histogram,
  type LengthFormat,
  type ScreenPoint,
  colormapNames,
  colourAt,
  extent,
  formatCount,
  formatLength,
  formatNumber,
  histogram,
  lengthFormat,
  median,
} from '../view/index.js';
