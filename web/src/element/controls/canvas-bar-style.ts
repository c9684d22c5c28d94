// The style of the bar on the canvas.

export const canvasBarStyle = /* css */ `
.bar-tools {
  position: absolute;
  inset-block-start: 10px;
  inset-inline-end: 10px;
  display: flex;
  flex-direction: column;
  align-items: flex-end;
  gap: 2px;
  color: var(--girth-quiet);
}
.bar-tools > button, .tool > button {
  display: grid;
  place-items: center;
  inline-size: 34px;
  block-size: 34px;
  padding: 0;
  margin-inline-start: auto;
}
.tool { position: relative; }
.bar-tools > button svg, .tool > button > svg:not(.axes) {
  inline-size: 20px;
  block-size: 20px;
  fill: none;
  stroke: currentColor;
  stroke-width: 1.6;
  stroke-linejoin: round;
}
.tool > button:has(.axes) { inline-size: 52px; block-size: 62px; }
.tool > button small { font-size: 11px; line-height: 1; }
.axes { inline-size: 48px; block-size: 46px; overflow: visible; }
.axes line { stroke: currentColor; stroke-width: 1.8; stroke-linecap: round; }
.axes text {
  fill: currentColor;
  font-size: 10px;
  font-weight: 600;
  text-anchor: middle;
  dominant-baseline: central;
}
.axes .away { opacity: 0.45; }
.axis-x { color: color-mix(in srgb, #e0402f 72%, var(--girth-ink)); }
.axis-y { color: color-mix(in srgb, #2aa344 72%, var(--girth-ink)); }
.axis-z { color: color-mix(in srgb, #2f74e0 72%, var(--girth-ink)); }
.tool .menu {
  position: absolute;
  inset: 0 calc(100% + 6px) auto auto;
  z-index: 2;
  display: grid;
  min-inline-size: 9rem;
  padding: 6px;
  color: var(--girth-ink);
  background: var(--girth-paper);
  border: 1px solid var(--girth-line);
  box-shadow: 0 6px 24px rgb(0 0 0 / 0.14);
}
.menu button { display: flex; align-items: center; justify-content: space-between; text-align: start; }
.menu button, .menu label { min-block-size: 32px; }
.menu label { display: flex; align-items: center; gap: 8px; padding-inline: 8px; cursor: pointer; }
.menu input { accent-color: var(--girth-accent); margin: 0; inline-size: 16px; block-size: 16px; }
.menu kbd { font: inherit; color: var(--girth-quiet); }
.menu select {
  font: inherit;
  color: inherit;
  background: var(--girth-paper);
  border: 1px solid color-mix(in srgb, var(--girth-ink) 55%, transparent);
  border-radius: 6px;
  min-block-size: 32px;
  margin: 4px 8px;
}
.menu :focus-visible { outline: 2px solid var(--girth-accent); outline-offset: 1px; }
`;
