// A line that a hand draws on the surface.

import type { CallOptions, FacePoint, SurfacePoint } from '../../kernel/types/types.js';

/** How a stroke is drawn; see `GirthViewer.chooseStroke`. */
export interface StrokeOptions extends CallOptions {
  /** The points so far, while the pointer moves. */
  drawn?: (points: readonly SurfacePoint[]) => void;
}

/** CSS pixels from one point of a stroke to the next: between them it runs straight on the surface. */
const spacing = 10;
/** Weights are written with so many digits: a hand is no surer, and links stay short. */
const digits = 4;

/**
 * The next stroke that begins on the surface: its points, one where the pointer does not move. A stroke that begins
 * beside it, or with another button, is left to whoever turns the surface. Never settled after the signal.
 */
export function strokeOn(
  canvas: HTMLCanvasElement,
  pick: (x: number, y: number) => FacePoint | undefined,
  signal: AbortSignal,
  drawn: (points: readonly SurfacePoint[]) => void,
): Promise<SurfacePoint[]> {
  return new Promise((resolve) => {
    let pointer: number | undefined;
    let at = { x: 0, y: 0 };
    const points: SurfacePoint[] = [];
    const take = ({ clientX, clientY }: PointerEvent): boolean => {
      const point = pick(clientX, clientY);
      if (!point) return false;
      at = { x: clientX, y: clientY };
      points.push(point);
      return true;
    };
    const listen = (
      type: 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel',
      act: (event: PointerEvent) => void,
    ): void => {
      // Strokes hear the pointer before the listeners that turn the surface or pin loops.
      canvas.addEventListener(type, act, { signal, capture: true });
    };
    listen('pointerdown', (event) => {
      if (pointer !== undefined) {
        event.stopImmediatePropagation();
        return;
      }
      if (event.button !== 0 || !event.isPrimary || !take(event)) return;
      event.stopImmediatePropagation();
      pointer = event.pointerId;
      canvas.setPointerCapture(pointer);
      canvas.focus();
    });
    listen('pointermove', (event) => {
      if (event.pointerId !== pointer) return;
      event.stopImmediatePropagation();
      const { clientX, clientY } = event;
      if (Math.hypot(clientX - at.x, clientY - at.y) >= spacing && take(event)) drawn(points);
    });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      listen(type, (event) => {
        if (event.pointerId !== pointer) return;
        event.stopImmediatePropagation();
        resolve(points);
      });
    }
  });
}

/** A point rounded to few digits, in which it is written. */
export function rounded(point: SurfacePoint): SurfacePoint {
  if (typeof point === 'number') return point;
  const {
    face,
    weights: [a, b],
  } = point;
  const round = (share: number): number => Number(share.toFixed(digits));
  const first = round(a);
  const second = Math.min(round(b), round(1 - first));
  return { face, weights: [first, second, Math.max(0, 1 - first - second)] };
}
