// The style of the element as it stands on its page, before anything is drawn. A page may set the custom properties
// on the element.

export const shellStyle = /* css */ `
:host {
  --girth-paper: #fbfbfa;
  --girth-ink: #1c1d21;
  --girth-quiet: #5d6069;
  --girth-line: #d9dade;
  --girth-accent: #c2410c;
  --girth-on-accent: #ffffff;
  display: flex;
  flex-direction: column;
  position: relative;
  min-block-size: 12rem;
  aspect-ratio: 4 / 3;
  overflow: hidden;
  container-type: inline-size;
  background: var(--girth-backdrop, var(--girth-paper));
  color: var(--girth-ink);
  font: 13px/1.4 system-ui, sans-serif;
  font-variant-numeric: tabular-nums;
}
@media (prefers-color-scheme: dark) {
  :host {
    --girth-paper: #16171a;
    --girth-ink: #ededf0;
    --girth-quiet: #b0b3bc;
    --girth-backdrop: radial-gradient(ellipse at 50% 45%, #3b3e46, #1d1f23 80%);
    --girth-line: #33353b;
    --girth-accent: #ff9466;
    --girth-on-accent: #1c1d21;
  }
}
:host([hidden]), [hidden] { display: none !important; }

.frame { position: relative; flex: 1 1 0; min-block-size: 0; block-size: 100%; inline-size: 100%; }
.poster, .poster img, ::slotted([slot='poster']) { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
.poster img, ::slotted([slot='poster']) { object-fit: contain; margin: 0; }
.figure-caption { flex: none; color: var(--girth-quiet); }
::slotted([slot='caption']) { display: block; padding: 8px 12px; }

button {
  font: inherit;
  color: inherit;
  background: none;
  border: 0;
  border-radius: 6px;
  cursor: pointer;
  padding: 0 8px;
  min-block-size: 28px;
}
button:hover { background: color-mix(in srgb, currentColor 12%, transparent); }
button:focus-visible { outline: 2px solid var(--girth-accent); outline-offset: 1px; }
button.cross { inline-size: 28px; padding: 0; font-size: 15px; line-height: 1; }

.message {
  position: absolute;
  inset-block-start: calc(var(--girth-top, 0px) + 12px);
  inset-inline: 12px;
  margin-inline: auto;
  max-inline-size: 34rem;
  inline-size: fit-content;
  display: flex;
  align-items: flex-start;
  gap: 8px;
  padding: 10px 8px 10px 14px;
  background: var(--girth-paper);
  border: 1px solid var(--girth-line);
  border-inline-start: 3px solid var(--girth-accent);
  border-radius: 8px;
  box-shadow: 0 6px 24px rgb(0 0 0 / 0.14);
}
.message p { margin: 0; padding-block: 4px; overflow-wrap: anywhere; }
.message p + p { padding-block-start: 0; color: var(--girth-quiet); }

`;
