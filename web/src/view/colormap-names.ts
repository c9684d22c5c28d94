// Which colour maps there are.

/**
 * The names, the default first. All but turbo and the diverging `rdbu`, which is for values on both sides
 * of 0, also read in order of lightness.
 */
export const colormapNames = ['viridis', 'cividis', 'plasma', 'magma', 'turbo', 'rdbu'] as const;

/** The name of a colour map. */
export type ColormapName = (typeof colormapNames)[number];

/** Whether colour-blind eyes can distinguish its values: turbo has the same colours twice for them. */
export function isForAllEyes(name: ColormapName): boolean {
  return name !== 'turbo';
}

/** Whether there is a colour map of that name. */
export function isColormapName(name: string | null | undefined): name is ColormapName {
  return (colormapNames as readonly (string | null | undefined)[]).includes(name);
}
