// How the command speaks: errors on standard error, one line each; numbers for people.
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::cli {

/// What somebody typed that cannot be, and what to type instead.
Error usageError(const std::string& what, const std::string& hint);

/// Prints `girth: FILE: CODE: what, where; hint` and returns the exit code. `file` may be empty.
int reportError(const std::string& file, const Error& error);

/// A number with six significant digits, for reading.
std::string readable(double value);

/// Seconds as "0.42 s" or "3 min 5 s".
std::string readableTime(double seconds);

/// " mm" for millimetres, and so on; nothing where the unit is not known: what to put behind a
/// length.
std::string unitSuffix(const std::string& unit);

}  // namespace girth::cli
