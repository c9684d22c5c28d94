// The girth of a chosen file: computed in workers, with progress, cancelled at once; then a table and a histogram.

import { createKernel, GirthError, unitSymbol, type Field, type Mesh } from 'girth';

const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const progress = byId<HTMLProgressElement>('progress');
const cancel = byId<HTMLButtonElement>('cancel');
const status = byId('status');

// One kernel for the page: it keeps its workers. Not awaited here: a file may be chosen before it is there.
const kernel = createKernel();

byId<HTMLInputElement>('file').addEventListener('change', ({ target }) => {
  const file = (target as HTMLInputElement).files?.[0];
  if (file) void show(file);
});

async function show(file: File): Promise<void> {
  const aborting = new AbortController();
  const { signal } = aborting;
  cancel.onclick = () => aborting.abort();
  cancel.disabled = false;
  status.textContent = `Computing the girth of ${file.name}`;
  let mesh: Mesh | undefined;
  try {
    mesh = await (await kernel).load(file, { signal });
    const onProgress = (share: number) => (progress.value = share);
    const field = await mesh.field('igf', { signal, onProgress });
    showTable(mesh, field);
    showHistogram(field);
    status.textContent = 'Done';
  } catch (error) {
    // Every failure has a stable code, a message and a hint what to do about it.
    if (!(error instanceof GirthError)) throw error;
    status.textContent =
      error.code === 'CANCELLED' ? 'Cancelled' : `${error.message}; ${error.hint}`;
  } finally {
    cancel.disabled = true;
    mesh?.dispose();
  }
}

function showTable({ info }: Mesh, { values, range: [least, greatest], unit }: Field): void {
  const sorted = values.slice().sort();
  const rows = {
    Vertices: String(info.vertexCount),
    'Least girth': `${least.toPrecision(4)} ${unitSymbol(unit)}`,
    'Median girth': `${sorted[sorted.length >> 1]!.toPrecision(4)} ${unitSymbol(unit)}`,
    'Greatest girth': `${greatest.toPrecision(4)} ${unitSymbol(unit)}`,
  };
  const table = byId<HTMLTableElement>('table');
  table.replaceChildren();
  for (const [name, value] of Object.entries(rows)) {
    const row = table.insertRow();
    row.insertCell().textContent = name;
    row.insertCell().textContent = value;
  }
}

function showHistogram({ values, range: [least, greatest], unit }: Field): void {
  const counts = new Array<number>(10).fill(0);
  const width = (greatest - least) / counts.length || 1;
  for (const value of values) {
    const bin = Math.min(Math.floor((value - least) / width), counts.length - 1);
    counts[bin]! += 1;
  }
  const most = Math.max(...counts);
  const lines = counts.map((count, bin) => {
    const from = (least + bin * width).toPrecision(3).padStart(8);
    return `${from} ${unitSymbol(unit)} ${'#'.repeat(Math.ceil((40 * count) / most))} ${count}`;
  });
  byId('histogram').textContent = lines.join('\n');
}
