#pragma once

#include <string>

#include "lessons/documents/document.h"
#include "textures/base/error.h"

namespace moontrace {

/// The line of an InputError that `run` throws; empty where it throws none.
template <typename Run>
std::string RefusalOf(Run run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// How often something was left out.
inline std::size_t CountOf(const Document& document, LeftOut what) {
  for (const LeftOutCount& one : document.left_out) {
    if (one.what == what) return one.count;
  }
  return 0;
}

}  // namespace moontrace
