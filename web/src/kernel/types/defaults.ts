// Made of the headers in cpp/include/girth by `npm run build:tables`: not to be edited.

/** The defaults of options of analyses. */
export const defaults = {
  coarseFaces: 10000,
  audit: 200,
  seed: 1,
  stations: 64,
  basePoints: 32,
  samples: 100,
} as const;
