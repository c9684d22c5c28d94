// The whole window takes dropped files.

const modelEnding = /\.(glb|gltf|obj)$/i;

/** The one to open of several files: the first that is a model by its name, or simply the first. */
export function chooseModel<Named extends { name: string }>(
  files: readonly Named[],
): Named | undefined {
  return files.find((file) => modelEnding.test(file.name)) ?? files[0];
}

/** Shows `curtain` while a file is over the window and calls `open` when one is dropped. */
export function acceptDrops(curtain: HTMLElement, open: (file: File) => void): void {
  const carriesFiles = (event: DragEvent): boolean =>
    event.dataTransfer?.types.includes('Files') ?? false;
  // Entering a child comes before leaving its parent: count both.
  let depth = 0;
  window.addEventListener('dragenter', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    ++depth;
    curtain.hidden = false;
  });
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
  });
  window.addEventListener('dragleave', (event) => {
    if (!carriesFiles(event)) return;
    depth = Math.max(0, depth - 1);
    curtain.hidden = depth === 0;
  });
  window.addEventListener('drop', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    depth = 0;
    curtain.hidden = true;
    const file = chooseModel([...event.dataTransfer!.files]);
    if (file) open(file);
  });
}
