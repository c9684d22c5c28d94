#include "process/machine.h"

#include <windows.h>

#include <array>

namespace girth::cli {

std::string machineName() {
  std::array<char, MAX_COMPUTERNAME_LENGTH + 1> name{};
  DWORD size = static_cast<DWORD>(name.size());
  return GetComputerNameA(name.data(), &size) != 0 ? name.data() : "";
}

}  // namespace girth::cli
