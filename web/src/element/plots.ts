/**
 * Plots of fields for a page around the element. Their style is in `girth/plots.css`.
 * @module girth/plots
 */

export * from '../view/plots/index.js';
