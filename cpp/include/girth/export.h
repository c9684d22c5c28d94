// The symbols that shared libraries show.
//
// Shared libraries (BUILD_SHARED_LIBS) hide everything but what is marked with GIRTH_EXPORT: the
// functions and classes of the public headers, and of the private ones what the project's other
// libraries use.
//
// GIRTH_SHARED is defined for those who link shared libraries, by girth::core and by pkg-config.
// For those who link static ones nothing is defined, and the mark means nothing.
#pragma once

#if __cplusplus < 202002L
#error "Girth needs C++20: compile with -std=c++20"
#endif

/// Marks what a shared library shows.
#if defined(GIRTH_BUILDING) || defined(GIRTH_SHARED)
#define GIRTH_EXPORT __attribute__((visibility("default")))
#else
#define GIRTH_EXPORT
#endif
