// Messages for people: errors on standard error, one line each, and numbers with their units.
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::cli {

/// An error of usage: what is wrong, and what to write instead.
Error usageError(const std::string& what, const std::string& hint);

/// From now on errors are also objects on standard output, for readers of `--json`:
/// {"file": ..., "error": {"code", "element", "message", "hint"}}.
void printErrorsAsJson();

/// Prints `girth: FILE: CODE: what, where; hint` and returns the exit code. `file` may be empty.
int reportError(const std::string& file, const Error& error);

/// From now on there is no progress, no note and no summary in words.
void beQuiet();
bool isQuiet();

/// From now on there is no summary in words, because standard output has something else.
void leaveOutSummary();
bool hasSummary();

/// Prints `girth: FILE: note: TEXT` on standard error, unless quiet.
void printNote(const std::string& file, const std::string& text);

/// A number with six significant digits and no exponent, for reading.
std::string readable(double value);

/// A value as `readable` writes it; "-" where there is no value.
std::string readableOrDash(double value);

/// Seconds as "0.42 s" or "3 min 5 s".
std::string readableTime(double seconds);

/// The unit behind a length: " mm" for millimetres, and so on; empty where the unit is not known.
std::string unitSuffix(const std::string& unit);

/// The unit behind an area: " mm²".
std::string areaSuffix(const std::string& unit);

/// Prints the line below a table that names the units of its columns; nothing where the unit is not
/// known.
void printUnits(const std::string& unit);

}  // namespace girth::cli
