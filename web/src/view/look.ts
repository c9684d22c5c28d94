// How a surface can be drawn.

/** Light that is smooth over the surface's faces, light on each face, or to be seen through. */
export const lookNames = ['smooth', 'flat', 'transparent'] as const;
/** One of these ways. */
export type Look = (typeof lookNames)[number];
