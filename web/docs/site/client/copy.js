// A button on each block of code, which copies it.

/** How long it says that it has. */
const saidFor = 1500;

/** Puts a button on every block. */
export function startCopying() {
  if (!navigator.clipboard) return;
  for (const block of document.querySelectorAll('main pre')) {
    const text = block.textContent ?? '';
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'copy';
    button.textContent = 'Copy';
    button.addEventListener('click', async () => {
      await navigator.clipboard.writeText(text);
      button.textContent = 'Copied';
      setTimeout(() => {
        button.textContent = 'Copy';
      }, saidFor);
    });
    const frame = document.createElement('div');
    frame.className = 'copied';
    block.replaceWith(frame);
    frame.append(block, button);
  }
}
