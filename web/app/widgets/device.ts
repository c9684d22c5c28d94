// Words that follow the device: a pointer clicks and hovers, a finger taps. In HTML the classes `by-pointer` and
// `by-finger` show one of two.

/** The words for whoever points at the page: `fingers` where nothing can hover. */
export const byDevice = (pointer: string, fingers: string): string =>
  matchMedia('(hover: none)').matches ? fingers : pointer;
