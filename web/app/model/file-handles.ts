// Handles of files that the system has given with them, where browsers have such: a file can be read again by it on another
// visit, as it is then.

const handles = new WeakMap<File, Promise<FileSystemFileHandle | undefined>>();

/** Notes a file's handle, and returns the file. */
export function keepHandle(
  file: File,
  handle: FileSystemFileHandle | Promise<FileSystemHandle | null>,
): File {
  const kept = Promise.resolve<FileSystemHandle | null>(handle).then(
    (handle) => (handle?.kind === 'file' ? (handle as FileSystemFileHandle) : undefined),
    () => undefined,
  );
  handles.set(file, kept);
  return file;
}

/** The handle of a file; undefined where there is none. */
export async function handleOf(file: File): Promise<FileSystemFileHandle | undefined> {
  return handles.get(file);
}
