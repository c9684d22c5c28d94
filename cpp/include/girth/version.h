// The version of the library, and how it marks what is to go and what may still change.
//
// GIRTH_VERSION_MAJOR, GIRTH_VERSION_MINOR and GIRTH_VERSION_PATCH are its numbers, GIRTH_VERSION
// all three as a text, such as "1.2.3". Versions are semantic (semver.org): only a new major
// version changes the interface (web/docs/stable.md). CHANGELOG.md has the old names and the new
// ones.
//
// A name that is to be removed is marked with GIRTH_DEPRECATED, with what to use instead, and stays
// until the next major version; compilers warn where it is used.
//
// A header with GIRTH_EXPERIMENTAL in the comment at its top may change in any version, a patch
// too. All of girth/study/ is experimental. Everything else is meant to last.
#pragma once

#include <string_view>

#include "girth/export.h"
#include "girth/version_numbers.h"

/// Marks a declaration that will be removed; `message` states what to use instead.
#define GIRTH_DEPRECATED(message) [[deprecated(message)]]

namespace girth {

/// The version of the library that the program was linked with, such as "1.2.3". GIRTH_VERSION is
/// that of the headers it was compiled with.
GIRTH_EXPORT std::string_view version();

}  // namespace girth
