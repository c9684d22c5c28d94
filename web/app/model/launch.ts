// Files that the system opens with the installed page.

import { keepHandle } from './file-handles.js';

interface LaunchQueue {
  setConsumer(take: (launch: { files?: readonly FileSystemFileHandle[] }) => void): void;
}

/** Calls `open` with files that the page was, or is, started with: they are still read. */
export function acceptLaunches(open: (files: Promise<File[]>) => void): void {
  const { launchQueue } = window as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files: handles = [] }) => {
    const read = handles.map(async (handle) => keepHandle(await handle.getFile(), handle));
    // Files that cannot be read are gone.
    const files = Promise.allSettled(read).then((results) =>
      results.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : [])),
    );
    open(files);
  });
}
