// The WebGL contexts of a page: a few, lent to the stages that draw. Browsers take the oldest contexts away where
// there are many, and what they showed is blank from then on. So a stage that has to do without keeps a picture of
// what it has drawn.

import { type Graphics, type Renderer, rendererFor } from './renderer.js';

/** So many contexts are alive at most. */
export const mostContexts = 8;

/** A context with its canvas. */
export interface Drawer {
  readonly renderer: Renderer;
  readonly canvas: HTMLCanvasElement;
  /** Whether it draws: the browser may take a context away, or have none. */
  graphics: Graphics;
}

/** A stage that borrows a renderer. */
export interface Borrower {
  /** Whether nothing of it can be seen: it gives back first. */
  readonly isResting: boolean;
  /** Keeps a picture and gives the drawer back. */
  yield(): void;
  /** The browser has taken the context away, or has given it back. */
  graphicsChanged(): void;
}

export class RendererPool {
  /** Whoever drew longest ago comes first. */
  readonly #lent = new Map<Borrower, Drawer>();
  readonly #idle: Drawer[] = [];
  readonly #make: (changed: (drawer: Drawer) => void) => Drawer;
  readonly #most: number;

  /** `make` calls back when what it has made no longer draws, or draws again. */
  constructor(make: (changed: (drawer: Drawer) => void) => Drawer, most: number) {
    this.#make = make;
    this.#most = most;
  }

  /** How many contexts are alive. */
  get size(): number {
    return this.#lent.size + this.#idle.length;
  }

  /** Whether the browser has WebGL 2. */
  check(): Graphics {
    if (this.size === 0) this.#idle.push(this.#made());
    const [drawer] = [...this.#idle, ...this.#lent.values()];
    return drawer!.graphics === 'missing' ? 'missing' : 'drawing';
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
      if (drawer.graphics !== 'lost') return drawer;
      drawer.renderer.dispose();
    }
    if (this.#lent.size < this.#most) return this.#made();
    const all = [...this.#lent.keys()];
    (all.find(({ isResting }) => isResting) ?? all[0]!).yield();
    return this.#idle.pop() ?? this.#made();
  }

  #made(): Drawer {
    return this.#make((drawer) => {
      for (const [borrower, held] of this.#lent) if (held === drawer) borrower.graphicsChanged();
    });
  }
}

/** The renderers of the page. */
export const renderers = new RendererPool((changed) => {
  const canvas = document.createElement('canvas');
  Object.assign(canvas.style, { display: 'block', inlineSize: '100%', blockSize: '100%' });
  const { renderer, graphics } = rendererFor(canvas, (graphics) => {
    drawer.graphics = graphics;
    changed(drawer);
  });
  const drawer: Drawer = { renderer, canvas, graphics };
  return drawer;
}, mostContexts);
