// How a worker reads files, at once, since the C++ reader asks for them in the middle of its work. In Node.js
// other functions take the place of these (`web/src/node/worker-scope.ts`).

export interface WorkerFiles {
  /** The bytes of a file. Throws where they cannot be read. */
  bytesOf(content: Blob): Uint8Array<ArrayBuffer>;
  /** The file of a relative name beside an address; undefined where it cannot be fetched. */
  beside(address: string, name: string): Uint8Array | undefined;
}

export const workerFiles: WorkerFiles = {
  bytesOf: (content) => new Uint8Array(new FileReaderSync().readAsArrayBuffer(content)),

  beside(address, name) {
    const request = new XMLHttpRequest();
    try {
      request.open('GET', addressBeside(address, name), false);
      request.responseType = 'arraybuffer';
      request.send();
    } catch {
      return undefined;
    }
    const isFound = request.status >= 200 && request.status < 300;
    return isFound ? new Uint8Array(request.response as ArrayBuffer) : undefined;
  },
};

/** The address of a relative name beside another address. Throws where that has none beside it. */
export function addressBeside(address: string, name: string): URL {
  return new URL(name.split('/').map(encodeURIComponent).join('/'), address);
}
