// The figures: what each live element on the pages shows. A page names one by its picture, images/live/NAME.webp,
// which `npm run build:posters` makes.

/**
 * @typedef {object} Figure
 * @property {string} model its name in the folder of models
 * @property {Record<string, string>} attributes of <girth-viewer>, beside src
 */

/** The size of the pictures, in pixels. */
export const posterSize = { width: 960, height: 720 };

/** @type {Record<string, Figure>} */
export const figures = {
  'chair-girth': { model: 'chair', attributes: { field: 'igf' } },
  'dumbbell-neck': { model: 'dumbbell', attributes: { field: 'igf', loop: '806' } },
  'dumbbell-faces': {
    model: 'dumbbell-coarse',
    attributes: { field: 'igf', loop: '90', edges: '', shading: 'flat' },
  },
  'dumbbell-far-end': { model: 'dumbbell', attributes: { field: 'igf', loop: '676' } },
  'three-handles': { model: 'handles', attributes: { field: 'igf', loop: '96 3174 1303' } },
  'hill-high': { model: 'hill-high', attributes: { field: 'igf', loop: '185' } },
  // The range is that of the high hill.
  'hill-low': {
    model: 'hill-low',
    attributes: { field: 'igf', loop: '185', range: '0.15 1.26' },
  },
  'cup-ear': { model: 'cup', attributes: { field: 'igf', loop: '1020 1816' } },
  'octopus-tips': { model: 'octopus', attributes: { field: 'tips' } },
  'octopus-jump': { model: 'octopus', attributes: { field: 'igf', loop: '3843 3790' } },
  'handles-two-loops': { model: 'handles', attributes: { field: 'igf', loop: '1230 1299' } },
  'octopus-geoaverage': { model: 'octopus', attributes: { field: 'geoaverage' } },
  'octopus-sdf': { model: 'octopus', attributes: { field: 'sdf' } },
  'chair-sdf': { model: 'chair', attributes: { field: 'sdf' } },
  'chair-parts': { model: 'chair', attributes: { field: 'parts' } },
  'spine-neck': { model: 'spine', attributes: { field: 'igf', pins: '704 neck' } },
  'vessel-narrowing': { model: 'vessel', attributes: { field: 'igf', pins: '120 narrowing' } },
  'dumbbell-waist': { model: 'dumbbell', attributes: { field: 'igf', pins: '806 waist' } },
  'hook-weak': { model: 'hook', attributes: { field: 'igf', pins: '456 weakest' } },
  'vessel-parts': { model: 'vessel', attributes: { field: 'parts' } },
};

/** @param {string} name */
export function figureOf(name) {
  const figure = figures[name];
  if (!figure) throw new Error(`there is no figure ${name} in web/docs/site/figures.mjs`);
  return figure;
}
