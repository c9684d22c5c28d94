// Dark or light by choice. The choice is the attribute `data-theme` of the page, which `start.ts` reads from where it is
// kept before anything is drawn, and follows; here is its control.

import { announce } from './widgets/announcer.js';
import { byId } from './widgets/dom.js';
import { Draft } from './widgets/draft.js';

/** The name under which the choice is kept, as `start.ts` knows it. */
const key = 'girth-theme';

/** `changed`: drawings in the page's colours have others now. */
export function offerTheme(changed: () => void): void {
  const root = document.documentElement;
  const list = byId<HTMLSelectElement>('theme');
  const draft = new Draft(list, {
    committed: (theme) => {
      if (theme === '') delete root.dataset['theme'];
      else root.dataset['theme'] = theme;
      window.dispatchEvent(new Event('themechange'));
      try {
        if (theme === '') localStorage.removeItem(key);
        else localStorage.setItem(key, theme);
      } catch {
        announce('For this visit: this browser keeps nothing for this page.');
      }
    },
  });
  draft.show(root.dataset['theme'] ?? '');
  new MutationObserver(changed).observe(root, { attributeFilter: ['data-scheme'] });
}
