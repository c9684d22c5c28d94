// The figures: live where the browser draws in three dimensions; otherwise their pictures stay.

/** Whether it does. */
function hasWebGL() {
  const context = document.createElement('canvas').getContext('webgl2');
  // It may hold only so many.
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

/** A figure is live once its field is complete; what keeps it from that is said below its picture. */
function bringToLife(/** @type {Element} */ figure) {
  const viewer = /** @type {Element} */ (figure.querySelector('girth-viewer'));
  viewer.addEventListener('field', () => figure.classList.add('lives'));
  viewer.addEventListener('error', (event) => {
    if (figure.classList.contains('lives')) return;
    const words = document.createElement('p');
    words.className = 'failure';
    words.textContent = `The figure is not live: ${/** @type {CustomEvent} */ (event).detail.message}`;
    figure.append(words);
  });
}

/** Fetches the element as soon as one of the page's figures is near. */
export function startFigures() {
  const figures = [...document.querySelectorAll('figure.live')];
  if (figures.length === 0 || !hasWebGL()) return;
  const near = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      near.disconnect();
      for (const figure of figures) bringToLife(figure);
      // A name by address: the element lies beside this script on the site only.
      void import(new URL('../girth/dist/girth-viewer.js', import.meta.url).href);
    },
    { rootMargin: '300px' },
  );
  for (const figure of figures) near.observe(figure);
}
