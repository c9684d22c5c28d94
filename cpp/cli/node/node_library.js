// The calls of node.h, in JavaScript; linked into the command's module. `require` is that of Node.js in every thread.

mergeInto(LibraryManager.library, {
  // Signals reach the first thread alone.
  girthCatchSignals__proxy: 'sync',
  girthCatchSignals__sig: 'vi',
  girthCatchSignals: function (flag) {
    for (const signal of ['SIGINT', 'SIGTERM']) {
      process.once(signal, () => Atomics.store(HEAPU8, flag, 1));
    }
  },

  girthProcessId__sig: 'i',
  girthProcessId: function () {
    return process.pid;
  },

  girthIsTerminal__sig: 'ii',
  girthIsTerminal: function (descriptor) {
    return require('tty').isatty(descriptor) ? 1 : 0;
  },

  girthAccess__deps: ['$ERRNO_CODES'],
  girthAccess__sig: 'iii',
  girthAccess: function (path, mode) {
    try {
      require('fs').accessSync(UTF8ToString(path), mode);
      return 0;
    } catch (error) {
      return ERRNO_CODES[error.code] || ERRNO_CODES.EIO;
    }
  },

  girthInflate__deps: ['malloc'],
  girthInflate__sig: 'iiiiii',
  girthInflate: function (packed, length, limit, isRaw, content) {
    const zlib = require('zlib');
    try {
      const inflate = isRaw ? zlib.inflateRawSync : zlib.gunzipSync;
      const bytes = inflate(HEAPU8.slice(packed >>> 0, (packed >>> 0) + length), {
        maxOutputLength: limit,
      });
      const room = _malloc(bytes.length || 1) >>> 0;
      if (!room) return -4;
      HEAPU8.set(bytes, room);
      HEAPU32[content >>> 2] = room;
      return bytes.length;
    } catch (error) {
      if (error.code === 'ERR_BUFFER_TOO_LARGE') return -3;
      if (error.code === 'Z_BUF_ERROR') return -2;
      return error.code === 'Z_DATA_ERROR' || error.code === 'Z_NEED_DICT' ? -1 : -4;
    }
  },
});
