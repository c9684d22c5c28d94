// Calls that Node.js answers for the command's WebAssembly module in place of the operating system.
// Defined in node_library.js.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Whatever signal of SIGINT and SIGTERM comes first sets the byte at `flag` to 1; the second one
/// of a kind ends the process.
void girthCatchSignals(void* flag);

int girthProcessId();

/// Whether a descriptor is a terminal: 1 or 0.
int girthIsTerminal(int descriptor);

/// 0, or the errno of why the process may not do with the file what `mode` asks (R_OK, W_OK, X_OK).
int girthAccess(const char* path, int mode);

/// Inflates `length` bytes, raw or all members of a gzip file, to at most `limit` bytes, in memory
/// that the caller frees: `*content`. Returns how many there are, or one of the numbers below.
int girthInflate(const void* packed, std::size_t length, std::size_t limit, int isRaw,
                 void** content);
}

namespace girth::cli {

inline constexpr int kDamaged = -1, kBreaksOff = -2, kTooLarge = -3, kNoMemory = -4;

}  // namespace girth::cli
