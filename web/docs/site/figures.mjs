// The figures: what each live element on the pages shows. A page names one by its picture, images/live/NAME.webp,
// which `npm run build:posters` makes.

/**
 * @typedef {object} Figure
 * @property {string} model its name in the folder of models
 * @property {Record<string, string>} attributes of <girth-viewer>, beside src
 */

/** Of the pictures, in pixels. */
export const posterSize = { width: 960, height: 720 };

/** @type {Record<string, Figure>} */
export const figures = {
  'chair-girth': { model: 'chair', attributes: { field: 'igf' } },
};

/** @param {string} name */
export function figureOf(name) {
  const figure = figures[name];
  if (!figure) throw new Error(`there is no figure ${name} in web/docs/site/figures.mjs`);
  return figure;
}
