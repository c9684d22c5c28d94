// From where a surface can be looked at straight. The views behind the names are in `camera-view.ts`.

/** Straight from the front, from the right and from above. */
export const straightNames = ['front', 'side', 'top'] as const;
/** The name of a straight direction. */
export type StraightName = (typeof straightNames)[number];
