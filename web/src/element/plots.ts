// Plots of fields for a page around the element, `girth/plots` on npm: what they need of style is in `plots.css`.

export * from '../view/plots/index.js';
