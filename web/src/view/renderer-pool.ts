// The WebGL contexts of a page: a few, lent to the stages that draw. Browsers take the oldest contexts away where
// there are many, and what they showed is blank from then on. So a stage that has to do without keeps a picture of
// what it has drawn.

import { WebGLRenderer } from 'three';

/** So many contexts are alive at most. */
export const mostContexts = 8;

/** A context with its canvas. */
export interface Drawer {
  readonly renderer: WebGLRenderer;
  readonly canvas: HTMLCanvasElement;
}

/** Who draws. */
export interface Borrower {
  /** Whether nothing of it can be seen: it gives back first. */
  readonly isResting: boolean;
  /** Keeps a picture and gives the drawer back. */
  yield(): void;
  /** The browser had taken the context away and has given it back: what it showed is gone. */
  restored(): void;
}

export class RendererPool {
  /** Whoever drew longest ago comes first. */
  readonly #lent = new Map<Borrower, Drawer>();
  readonly #idle: Drawer[] = [];
  readonly #make: () => Drawer;
  readonly #most: number;

  constructor(make: () => Drawer, most: number) {
    this.#make = make;
    this.#most = most;
  }

  /** How many contexts are alive. */
  get size(): number {
    return this.#lent.size + this.#idle.length;
  }

  /** Throws where the browser has no WebGL 2. */
  check(): void {
    if (this.size === 0) this.#idle.push(this.#made());
  }

  /** A drawer, until it is given back: the one that it has already, or another one. */
  lend(borrower: Borrower): Drawer {
    const held = this.#lent.get(borrower);
    this.#lent.delete(borrower);
    const drawer = held ?? this.#free();
    this.#lent.set(borrower, drawer);
    return drawer;
  }

  /** A borrower no longer draws. */
  giveBack(borrower: Borrower): void {
    const drawer = this.#lent.get(borrower);
    if (!drawer) return;
    this.#lent.delete(borrower);
    this.#idle.push(drawer);
  }

  /** A borrower is gone: what nobody needs now is let go of. */
  leave(borrower: Borrower): void {
    this.giveBack(borrower);
    const kept = this.#lent.size > 0 ? 1 : 0;
    for (const { renderer } of this.#idle.splice(kept)) {
      renderer.dispose();
      renderer.forceContextLoss();
    }
  }

  #free(): Drawer {
    for (let drawer = this.#idle.pop(); drawer; drawer = this.#idle.pop()) {
      if (!drawer.renderer.getContext().isContextLost()) return drawer;
      drawer.renderer.dispose();
    }
    if (this.#lent.size < this.#most) return this.#made();
    const all = [...this.#lent.keys()];
    (all.find(({ isResting }) => isResting) ?? all[0]!).yield();
    return this.#idle.pop() ?? this.#made();
  }

  #made(): Drawer {
    const drawer = this.#make();
    drawer.canvas.addEventListener('webglcontextrestored', () => {
      for (const [borrower, held] of this.#lent) if (held === drawer) borrower.restored();
    });
    return drawer;
  }
}

/** Those of the page. */
export const renderers = new RendererPool(() => {
  const canvas = document.createElement('canvas');
  Object.assign(canvas.style, { display: 'block', inlineSize: '100%', blockSize: '100%' });
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
  renderer.setClearColor(0x000000, 0);
  return { renderer, canvas };
}, mostContexts);
