#include "process/machine.h"

#include <unistd.h>

#include <array>

namespace girth::cli {

std::string machineName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

}  // namespace girth::cli
