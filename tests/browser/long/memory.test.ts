// Memory of the page: where it ends, and that it is given back.

import { expect, test } from 'vitest';
import type { GirthViewer } from '../../../web/src/element/index.js';
import { cubeIsComputed, faultyPages, isTooLarge, memoryEndsAt } from '../faulty-page.js';
import { torus } from '../meshes.js';
import { drop, modelIs } from '../page-support.js';

const { openWith } = faultyPages();

test('a file that fits into 64 MB, and whose surface does not: words, and the model before stays', async () => {
  const faulty = await openWith((page) => memoryEndsAt(page, 64 << 20));
  await modelIs(faulty.page, 'chair.glb');
  await drop(faulty.page, { name: 'large.obj', bytes: Buffer.from(torus(500, 400)) });
  await isTooLarge(faulty, 'large.obj');
});

test('200 loads and cancels: memory is what it was, to within 10%', async () => {
  const faulty = await openWith(() => Promise.resolve());
  const { page, viewer } = faulty;
  await modelIs(page, 'chair.glb');
  /** Most are overtaken while they are read, at different moments; some are cancelled while they are computed. */
  const load = async (times: number): Promise<void> => {
    await viewer.evaluate(
      async (element: GirthViewer, [text, times]) => {
        for (let i = 1; i <= times; ++i) {
          const loaded = element.load(new File([text], `${i}.obj`)).catch(() => undefined);
          if (i % 20 > 0) await new Promise((resolve) => setTimeout(resolve, i % 4));
          else await loaded;
          element.cancel();
        }
      },
      [torus(60, 40), times] as const,
    );
    await cubeIsComputed(faulty);
  };
  const session = await page.context().newCDPSession(page);
  const memory = async (): Promise<number> => {
    await session.send('HeapProfiler.collectGarbage');
    const used: { usedSize: number; backingStorageSize?: number } =
      await session.send('Runtime.getHeapUsage');
    return used.usedSize + (used.backingStorageSize ?? 0);
  };
  await load(20);
  const [before, workers] = [await memory(), page.workers().length];
  await load(200);
  await expect.poll(memory).toBeLessThan(1.1 * before);
  // Each has a module with a memory of its own. One may be on its way while they are counted.
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(workers + 1);
  expect(await faulty.message.isVisible()).toBe(false);
});
