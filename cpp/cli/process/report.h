// Messages for people: errors on standard error, one line each, and numbers with their units.
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::cli {

/// An error of usage: what is wrong, and what to write instead.
Error usageError(const std::string& what, const std::string& hint);

/// Prints `girth: FILE: CODE: what, where; hint` and returns the exit code. `file` may be empty.
int reportError(const std::string& file, const Error& error);

/// A number with six significant digits, for reading.
std::string readable(double value);

/// Seconds as "0.42 s" or "3 min 5 s".
std::string readableTime(double seconds);

/// What follows a length: " mm" for millimetres, and so on; empty where the unit is not known.
std::string unitSuffix(const std::string& unit);

/// What follows an area: " mm²".
std::string areaSuffix(const std::string& unit);

/// Prints the line below a table that names the units of its columns; nothing where the unit is not
/// known.
void printUnits(const std::string& unit);

}  // namespace girth::cli
