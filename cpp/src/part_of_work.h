// Work in several parts, under one context.
#pragma once

#include "girth/execution.h"

namespace girth {

/// The part of a work's progress between two shares of the whole. The context must outlive it.
inline ExecutionContext partOf(const ExecutionContext& context, double begin, double end) {
  ExecutionContext part = context;
  if (context.onProgress) {
    part.onProgress = [&context, begin, end](double fraction) {
      context.onProgress(begin + (end - begin) * fraction);
    };
  }
  return part;
}

}  // namespace girth
