// The renderer that draws on the canvas: WebGL 2, or nothing where the browser has none. All else works without a picture.

import { WebGLRenderer } from 'three';

/** The part of three.js's renderer that is used here. */
export type Renderer = Pick<
  WebGLRenderer,
  | 'clippingPlanes'
  | 'compileAsync'
  | 'dispose'
  | 'forceContextLoss'
  | 'getPixelRatio'
  | 'getSize'
  | 'render'
  | 'setPixelRatio'
  | 'setSize'
>;

/** 'lost': the browser has taken the graphics away, and may give them back. */
export type Graphics = 'drawing' | 'lost' | 'missing';

/** Draws nothing. */
function blindRenderer(): Renderer {
  let ratio = 1;
  const size = { x: 1, y: 1 };
  return {
    clippingPlanes: [],
    compileAsync: (object) => Promise.resolve(object),
    dispose: () => undefined,
    forceContextLoss: () => undefined,
    getPixelRatio: () => ratio,
    getSize: (target) => target.set(size.x, size.y),
    render: () => undefined,
    setPixelRatio: (value = 1) => void (ratio = value),
    setSize: (width, height) => void Object.assign(size, { x: width, y: height }),
  };
}

/** Draws on the canvas; undefined where the browser has no WebGL 2. */
function webglRenderer(canvas: HTMLCanvasElement): Renderer | undefined {
  // Without this question three.js would write an error of its own to the console.
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, stencil: true });
  if (!context) return undefined;
  try {
    const renderer = new WebGLRenderer({ canvas, context });
    renderer.setClearColor(0x000000, 0);
    return renderer;
  } catch {
    return undefined;
  }
}

/**
 * A renderer for a canvas. `changed` is called when the browser takes the graphics away and when it has given
 * them back; three.js then makes everything anew by itself.
 */
export function rendererFor(
  canvas: HTMLCanvasElement,
  changed: (graphics: Graphics) => void,
): { renderer: Renderer; graphics: Graphics } {
  const renderer = webglRenderer(canvas);
  if (!renderer) return { renderer: blindRenderer(), graphics: 'missing' };
  canvas.addEventListener('webglcontextlost', () => changed('lost'));
  canvas.addEventListener('webglcontextrestored', () => changed('drawing'));
  return { renderer, graphics: 'drawing' };
}
