// Surroundings of the element: its size, whether it is in view, the wish for less motion.

export interface SurroundingsEvents {
  /** The element has this size in CSS pixels. */
  resized(width: number, height: number): void;
  /** The element has come into view, or has left it. */
  sighted(isInView: boolean): void;
  /** The system's wish for less motion is another one; at first, what it is. */
  motionChanged(isReduced: boolean): void;
}

const reducedMotion = '(prefers-reduced-motion: reduce)';

/** Whether the system asks for less motion. */
export function isMotionReduced(): boolean {
  return window.matchMedia(reducedMotion).matches;
}

/** Watches until the returned function is called. */
export function watchSurroundings(element: HTMLElement, events: SurroundingsEvents): () => void {
  const size = new ResizeObserver(() => events.resized(element.clientWidth, element.clientHeight));
  size.observe(element);
  const view = new IntersectionObserver((entries) =>
    events.sighted(entries.at(-1)!.isIntersecting),
  );
  view.observe(element);
  const motion = window.matchMedia(reducedMotion);
  const changed = (): void => events.motionChanged(motion.matches);
  motion.addEventListener('change', changed);
  changed();
  return () => {
    size.disconnect();
    view.disconnect();
    motion.removeEventListener('change', changed);
  };
}
