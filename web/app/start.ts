// The page's first module: starts the others, and puts into words whatever keeps one of them from starting.
//
// It imports nothing by itself, so that it runs whatever the others do. A promise carries what they throw,
// also behind a top-level await, where some browsers report nothing.

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

void import('./main.js').catch(show).then(() => document.getElementById('not-started')!.remove());
