// Whatever is done in whatever order, and before the last of it has come: the page shows what its state says.

import type { Page } from 'playwright-core';
import { expect, test, vi } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { readState } from '../../web/app/state/address-state.js';
import { randomFrom } from '../web/app/random-state.js';
import { box } from './meshes.js';
import { builtPage, drop, fragment, modelIs } from './page-support.js';

const openBuilt = builtPage();

/** Waits until the newest model is there, and the address stays as it is. */
async function atRest(page: Page): Promise<void> {
  let before = '';
  await expect
    .poll(
      async () => {
        const now = `${fragment(page)} ${await page.title()}`;
        const isSame = now === before;
        before = now;
        const isReading = await page.getByText(/^Reading /).isVisible();
        return isSame && !isReading;
      },
      { interval: 400, timeout: 60_000 },
    )
    .toBe(true);
}

/** The content of the page, in the words of its state. */
const shownOn = (page: Page) =>
  page.evaluate(() => {
    const viewer = document.querySelector<GirthViewer>('girth-viewer')!;
    const value = (id: string) => document.querySelector<HTMLSelectElement>(`#${id}`)!.value;
    const open = document.querySelector('details.panel[open]')?.id;
    return {
      model: viewer.info!.name.replace(/\.glb$/, ''),
      field: viewer.getAttribute('field') ?? 'igf',
      fieldChoice: value('field-name'),
      colormap: viewer.getAttribute('colormap') ?? 'viridis',
      colormapChoice: value('colormap'),
      isolines: Number(viewer.getAttribute('isolines') ?? 0),
      isolinesChoice: Number(value('isolines')),
      log: viewer.hasAttribute('log'),
      logChoice: document.querySelector<HTMLInputElement>('#log')!.checked,
      loops: viewer.pinned.map(({ loop, name }) => [loop.base, name]),
      panel: open?.replace('-panel', '') ?? 'loops',
    };
  });

/** The content by the state that the address has. */
function saidBy(text: string) {
  const { model, file, field, colormap, isolines, log, loops, names, panel } = readState(text);
  const [fieldChoice, colormapChoice] = [field ?? 'igf', colormap ?? 'viridis'];
  return {
    model: model ?? file,
    ...{ field: fieldChoice, fieldChoice, colormap: colormapChoice, colormapChoice },
    ...{ isolines: isolines ?? 0, isolinesChoice: isolines ?? 0 },
    ...{ log: log ?? false, logChoice: log ?? false },
    loops: (loops ?? []).map((base, i) => [base, names?.[i] ?? '']),
    panel: panel ?? 'loops',
  };
}

test.each([49, 2026])('random actions, none of which waits for another: seed %i', async (seed) => {
  const random = randomFrom(seed);
  const { page, viewer } = await openBuilt('model=cup&colormap=turbo');
  await modelIs(page, 'cup.glb');
  const press = (where: string) => page.locator(where).dispatchEvent('click');
  const actions: (() => Promise<unknown>)[] = [
    () =>
      page
        .getByRole('button', { name: random.of(['Cup', 'Dumbbell', 'Hook']) })
        .dispatchEvent('click'),
    () => page.locator('#colormap').selectOption(random.of(['viridis', 'turbo', 'magma'])),
    () => page.locator('#field-name').selectOption(random.of(['igf', 'sdf', 'geofarthest'])),
    () => page.locator('#isolines').selectOption(random.of(['0', '10', '20'])),
    () => press('#log'),
    () => press('#undo'),
    () => press('#undo'),
    () => press('#redo'),
    () => press(`#${random.of(['tips', 'limbs', 'necks', 'parts'])}-panel > summary`),
    () =>
      page.setViewportSize(
        random.of([
          { width: 800, height: 640 },
          { width: 1280, height: 800 },
        ]),
      ),
    () =>
      viewer.evaluate((element: GirthViewer, at) => {
        void element.pin(at).catch(() => undefined);
      }, random.below(8)),
    () =>
      drop(page, {
        name: random.of(['one.obj', 'two.obj']),
        bytes: Buffer.from(box(1, 2, 2 + random.below(2))),
      }),
    () => page.waitForTimeout(random.below(600)),
  ];
  for (let round = 0; round < 15; ++round) {
    for (let step = 0; step < 10; ++step) await random.of(actions)();
    await atRest(page);
    // Slow changes may come after a rest.
    await vi.waitFor(
      async () => expect(await shownOn(page), `round ${round}`).toEqual(saidBy(fragment(page))),
      { timeout: 20_000, interval: 300 },
    );
  }
});

test('undone while another model is being read: the one that was shown stays', async () => {
  const { page } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  await page.locator('#colormap').selectOption('magma');
  await page.locator('#undo').click();
  await page.getByRole('button', { name: 'Hook' }).evaluate((hook: HTMLElement) => {
    hook.click();
    document.querySelector<HTMLElement>('#redo')!.click();
  });
  await atRest(page);
  expect(fragment(page)).toBe('model=cup&colormap=magma');
  expect(await shownOn(page)).toMatchObject({ model: 'cup', colormap: 'magma' });
});
