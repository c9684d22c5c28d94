// The page's first module: starts the others, and puts into words whatever keeps one of them from starting.
//
// It also says whether the page is dark, before anything is drawn, and keeps files that are dropped early. It
// imports nothing by itself, so that it runs whatever the others do. A promise carries what they throw, also
// behind a top-level await, where some browsers report nothing.

/** Words for what was thrown; a module that could not be fetched and one that failed look alike. */
function wordsFor(error: unknown): string {
  const message = error instanceof Error ? error.message : String(error);
  return `Girth could not start: ${message.replace(/\.$/, '') || 'no reason is known'}.`;
}

function show(error: unknown): void {
  console.warn(error);
  const words = document.getElementById('start-failure')!;
  words.querySelector('b')!.textContent = wordsFor(error);
  words.hidden = false;
  document.getElementById('invitation')!.hidden = true;
}

// ---- dark or light: as it was chosen, otherwise as the system has it

const root = document.documentElement;
const prefersDark = matchMedia('(prefers-color-scheme: dark)');
function followTheme(): void {
  root.dataset['scheme'] = root.dataset['theme'] ?? (prefersDark.matches ? 'dark' : 'light');
}
try {
  const theme = localStorage.getItem('girth-theme');
  if (theme === 'dark' || theme === 'light') root.dataset['theme'] = theme;
} catch {
  // Nothing is kept for this page.
}
followTheme();
prefersDark.addEventListener('change', followTheme);
window.addEventListener('themechange', followTheme);

// ---- files that are dropped before there is anybody to take them: they are kept until then

const early: { files: File[]; items: object[] }[] = [];
function allow(event: DragEvent): void {
  if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
}
function keep(event: DragEvent): void {
  allow(event);
  const { files, items } = event.dataTransfer!;
  // Afterwards the drop is forgotten, but not what was asked for at once.
  const kept = [...items].map((item) => {
    const entry = item.webkitGetAsEntry?.() ?? null;
    return { kind: item.kind, webkitGetAsEntry: () => entry };
  });
  if (files.length > 0) early.push({ files: [...files], items: kept });
}
window.addEventListener('dragover', allow);
window.addEventListener('drop', keep);
window.addEventListener('takedrops', (event) => {
  window.removeEventListener('dragover', allow);
  window.removeEventListener('drop', keep);
  const last = early.pop();
  if (last) (event as CustomEvent<(dropped: object) => void>).detail(last);
});

void import('./main.js').catch(show).then(() => document.getElementById('not-started')!.remove());
