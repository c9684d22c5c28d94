// The memory of the processes that pages and their workers live in.

import { readFileSync, writeFileSync } from 'node:fs';
import type { Browser } from 'playwright-core';

/** From now on: the bytes that a renderer's process comes to hold beyond those that it holds now, at most. */
export async function watchMemory(browser: Browser): Promise<() => number> {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const renderers = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id);
  for (const id of renderers) writeFileSync(`/proc/${id}/clear_refs`, '5');
  const before = renderers.map((id) => memoryOf(id, 'VmRSS'));
  return () => Math.max(...renderers.map((id, i) => memoryOf(id, 'VmHWM') - before[i]!));
}

/** Bytes that a process holds, at present or at most since its peak was forgotten. */
function memoryOf(process: number, what: 'VmRSS' | 'VmHWM'): number {
  const status = readFileSync(`/proc/${process}/status`, 'utf8');
  return 1024 * Number(new RegExp(`${what}:\\s+(\\d+)`).exec(status)![1]);
}
