// The page without a network: registers the service worker, says when the page can do without, offers a new version, and
// installing.

import { make } from '../src/element/index.js';
import { byId } from './widgets/dom.js';

/** Milliseconds between two looks for a new version, at least, on a page that stays open. */
const lookAgain = 3_600_000;

/** An event that browsers send where the page can be installed. */
interface InstallEvent extends Event {
  prompt(): Promise<unknown>;
}

/** Offers installing where the browser can do it and has not done it. */
export function offerInstalling(): void {
  const button = byId('install');
  let asked: InstallEvent | undefined;
  window.addEventListener('beforeinstallprompt', (event) => {
    event.preventDefault();
    asked = event as InstallEvent;
    button.hidden = false;
  });
  button.addEventListener('click', () => {
    button.hidden = true;
    // The browser has said itself what went wrong.
    void asked?.prompt().catch(() => undefined);
  });
  window.addEventListener('appinstalled', () => (button.hidden = true));
}

/** Makes the page work offline from now on, where the browser lets it; where not, nothing is different. */
export async function workOffline(): Promise<void> {
  // Not on pages without a safe connection, and not in windows that keep nothing.
  const container = navigator.serviceWorker as ServiceWorkerContainer | undefined;
  const registration = await container
    ?.register(new URL('service-worker.js', document.baseURI), { updateViaCache: 'none' })
    .catch(() => undefined);
  if (!container || !registration) return;
  const offer = makeOffer(() => {
    const { waiting } = registration;
    // The waiting version reloads this page when it takes over.
    if (waiting) waiting.postMessage('take over');
    else location.reload();
  });
  const hadVersion = container.controller !== null;
  const watch = (coming: ServiceWorker | null): void =>
    coming?.addEventListener('statechange', () => {
      if (coming.state === 'installed' && hadVersion) offer.show();
    });
  watch(registration.installing);
  registration.addEventListener('updatefound', () => watch(registration.installing));
  if (registration.waiting && hadVersion) offer.show();
  container.addEventListener('controllerchange', () => {
    if (offer.isTaken) location.reload();
    // Another window of this page has taken it.
    else if (hadVersion) offer.show();
  });
  let lastLook = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.hidden || Date.now() - lastLook < lookAgain) return;
    lastLook = Date.now();
    void registration.update().catch(() => undefined);
  });
  await container.ready;
  byId('offline').textContent = 'This page works offline, too.';
}

interface Offer {
  isTaken: boolean;
  show(): void;
}

function makeOffer(take: () => void): Offer {
  const reload = make('button', { type: 'button', class: 'open' }, 'Reload');
  const later = make('button', { type: 'button', class: 'more' }, 'Later');
  const words = make('span');
  const note = make('div', { class: 'note', role: 'status', hidden: '' }, words, reload, later);
  document.querySelector('main')!.append(note);
  const offer = {
    isTaken: false,
    show: () => {
      note.hidden = false;
      words.textContent = 'A new version is available.';
    },
  };
  reload.addEventListener('click', () => {
    offer.isTaken = true;
    take();
  });
  later.addEventListener('click', () => (note.hidden = true));
  return offer;
}
