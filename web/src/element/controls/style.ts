// The style of what is drawn on the surface and beside it.

import { canvasBarStyle } from './canvas-bar-style.js';

export const style = /* css */ `
canvas {
  position: absolute;
  inset: 0;
  inline-size: 100%;
  block-size: 100%;
  touch-action: none;
  cursor: grab;
  outline: none;
}
canvas:active { cursor: grabbing; }
canvas.picking, canvas.choosing { cursor: crosshair; }
canvas:focus-visible { outline: 2px solid var(--girth-accent); outline-offset: -3px; }

.plate {
  background: color-mix(in srgb, var(--girth-paper) 86%, transparent);
  border-radius: 8px;
}

.legend {
  position: absolute;
  inset-inline-start: 16px;
  inset-block-end: 64px;
  margin: 0;
  pointer-events: none;
  text-shadow: 0 0 2px var(--girth-paper), 0 0 3px var(--girth-paper), 0 0 4px var(--girth-paper),
    0 0 6px var(--girth-paper), 0 0 8px var(--girth-paper);
}
:host([controls=none]) .legend { display: none; }
.legend-title { margin-block-end: 10px; color: var(--girth-quiet); }
.legend-bar {
  position: relative;
  inline-size: 10px;
  block-size: clamp(72px, 18vh, 150px);
  border-radius: 5px;
  background: linear-gradient(to top, var(--colours));
}
.legend-tick {
  position: absolute;
  inset-inline-start: 18px;
  inset-block-end: calc(100% * var(--place));
  transform: translateY(50%);
  line-height: 1;
  white-space: nowrap;
}
.legend-line {
  position: absolute;
  inset-inline: 0;
  inset-block-end: calc(100% * var(--place));
  block-size: 1px;
  background: rgb(255 255 255 / 0.75);
}
/* An end beyond which there is more is a tip. */
.legend-bar.more-above { border-start-start-radius: 0; border-start-end-radius: 0; }
.legend-bar.more-below { border-end-start-radius: 0; border-end-end-radius: 0; }
.legend-bar.more-above::before, .legend-bar.more-below::after {
  content: '';
  position: absolute;
  inset-inline: 0;
  block-size: 8px;
  background: inherit;
  clip-path: polygon(50% 0, 100% 100%, 0 100%);
}
.legend-bar.more-above::before { inset-block-end: 100%; background: var(--top); }
.legend-bar.more-below::after { inset-block-start: 100%; background: var(--bottom); transform: scaleY(-1); }
.legend-beyond { margin: 14px 0 0; color: var(--girth-quiet); max-inline-size: 13rem; line-height: 1.3; }
.legend-beyond button {
  pointer-events: auto;
  padding: 0 2px;
  margin: 0;
  color: var(--girth-accent);
  font-weight: 600;
  min-block-size: 24px;
}
.legend-key { list-style: none; margin: 0; padding: 0; display: grid; gap: 4px; }
.legend-key li { display: flex; align-items: center; gap: 8px; }
.legend-key i {
  inline-size: 12px;
  block-size: 12px;
  border-radius: 3px;
  background: var(--colour);
  box-shadow: 0 0 0 1px color-mix(in srgb, var(--girth-ink) 22%, transparent);
}
.legend-key i.hatched {
  background: repeating-linear-gradient(135deg, rgb(0 0 0 / 0.3) 0 2px, transparent 2px 4px) var(--colour);
}
.legend-note { margin: 12px 0 0; color: var(--girth-quiet); max-inline-size: 15rem; }
/* A narrow element lays the legend down, so that it leaves the surface its room. */
@container (max-width: 520px) {
  .legend { inset-inline: 20px; inset-block-end: 50px; display: flex; align-items: flex-start; gap: 16px; }
  .legend-title { margin: 0; white-space: nowrap; margin-block-start: -5px; }
  .legend-bar {
    flex: 1;
    inline-size: auto;
    block-size: 8px;
    margin-block-end: 20px;
    background: linear-gradient(to right, var(--colours));
  }
  .legend-tick {
    inset-inline-start: calc(100% * var(--place));
    inset-block: 14px auto;
    transform: translateX(-50%);
  }
  .legend-tick:first-child { transform: translateX(-100%); }
  .legend-tick:last-child { transform: none; }
  .legend-tick.inner { display: none; }
  .legend-bar.more-above::before, .legend-bar.more-below::after { display: none; }
  .legend-beyond { position: absolute; inset: 40px 0 auto auto; margin: 0; max-inline-size: none; white-space: nowrap; }
  .legend-beyond span { display: none; }
  .legend-line { inset-inline: calc(100% * var(--place)) auto; inset-block: 0; inline-size: 1px; block-size: auto; }
  .legend-key { display: flex; flex-wrap: wrap; gap: 2px 14px; margin-block-start: -5px; }
  .legend-note { margin: -5px 0 0; max-inline-size: 8rem; }
  /* Beside the bar on the canvas. */
  .message:not([hidden]) { inset-inline-end: 60px; }
}

.status {
  position: absolute;
  inset-inline: 12px;
  inset-block-end: 12px;
  display: flex;
  align-items: flex-end;
  gap: 12px;
  pointer-events: none;
}
.status .plate { pointer-events: auto; }
.runs:not([hidden]) { min-inline-size: 0; display: flex; flex-direction: column; align-items: flex-start; gap: 6px; }
.progress { min-inline-size: 0; display: flex; align-items: center; gap: 4px 12px; padding-inline: 12px 4px; block-size: 36px; }
.work { display: flex; align-items: center; gap: 4px 12px; padding-inline: 12px 4px; block-size: 36px; min-inline-size: 0; }
.work span { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.work progress { inline-size: clamp(48px, 12vw, 120px); block-size: 4px; accent-color: var(--girth-accent); }
.track {
  inline-size: clamp(80px, 24vw, 240px);
  min-inline-size: 40px;
  flex-shrink: 100;
  block-size: 4px;
  border-radius: 2px;
  background: color-mix(in srgb, var(--girth-ink) 16%, transparent);
  overflow: hidden;
}
.bar { block-size: 100%; background: var(--girth-accent); transform-origin: 0 50%; transform: scaleX(0); }
.what { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.share { min-inline-size: 4ch; text-align: end; }
.left { min-inline-size: 11ch; color: var(--girth-quiet); white-space: nowrap; }
.partial { display: flex; align-items: center; gap: 8px; padding-inline: 12px 4px; block-size: 36px; white-space: nowrap; }
.partial button { color: var(--girth-accent); font-weight: 600; }

/* Where there is no room for both, the message comes first: it can be dismissed. */
@media (max-width: 720px) and (max-height: 560px) {
  .legend:has(~ .message:not([hidden])) { visibility: hidden; }
}

.readout {
  position: absolute;
  inset: 0 auto auto 0;
  max-inline-size: 17rem;
  padding: 6px 12px;
  border-radius: 8px;
  background: rgb(20 21 24 / 0.9);
  color: #fff;
  pointer-events: none;
  white-space: nowrap;
  will-change: transform;
}
.readout b { font-size: 15px; font-weight: 650; }
.readout span { color: #d2d4da; margin-inline-start: 6px; }
.readout small { display: block; font-size: 12px; color: #d2d4da; white-space: normal; inline-size: 15rem; }

.tag {
  position: absolute;
  inset: 0 auto auto 0;
  display: flex;
  align-items: center;
  border-radius: 14px;
  padding-inline-start: 10px;
  background: rgb(20 21 24 / 0.86);
  color: #fff;
  white-space: nowrap;
  pointer-events: none;
  will-change: transform;
}
.leaders {
  position: absolute;
  inset: 0;
  inline-size: 100%;
  block-size: 100%;
  overflow: visible;
  pointer-events: none;
}
.leaders line { stroke: #ff7a45; stroke-width: 1.25; }
.numbers { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.number-mark {
  position: absolute;
  inset: 0 auto auto 0;
  padding: 1px 7px;
  border-radius: 10px;
  background: rgb(20 21 24 / 0.78);
  color: #fff;
  font-size: 12px;
  font-weight: 600;
  white-space: nowrap;
}
.number-mark.behind { opacity: 0.35; }
.tag.behind { opacity: 0.7; }
.tag i { font-style: normal; color: #ffb08a; margin-inline-end: 6px; font-weight: 650; }
.tag b:not(:empty) { margin-inline-end: 8px; font-weight: 600; }
.tag button { border-radius: 14px; pointer-events: auto; }
.tag button:focus-visible { outline-color: #ffb08a; }

.quiet-live {
  position: absolute;
  inline-size: 1px;
  block-size: 1px;
  overflow: hidden;
  clip-path: inset(50%);
}

/* On paper: a figure where there is one, otherwise what is on the screen without what only hands need. */
.printed { display: none; }
@media print {
  :host { background: none; }
  canvas { object-fit: contain; }
  .status, .bar-tools, .readout, .tag button { display: none; }
  .frame:has(> .printed) > :not(.printed) { display: none; }
  .printed { display: block; cursor: auto; }
}

/* Colours that distinguish things stay where the system has few colours. */
@media (forced-colors: active) {
  .legend-bar, .legend-key i, .legend-line, .axes { forced-color-adjust: none; }
  .legend-bar, .legend-key i { outline: 1px solid CanvasText; }
  .legend { text-shadow: none; background: Canvas; padding: 4px; }
  .track { border: 1px solid CanvasText; }
  .bar { forced-color-adjust: none; background: Highlight; }
  .tag, .readout, .plate, .message { border: 1px solid CanvasText; }
  .bar-tools button[aria-expanded='true'] { outline: 2px solid Highlight; }
}
${canvasBarStyle}`;
