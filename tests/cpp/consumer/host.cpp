// Loads the plugin that is named to it and catches by type what comes out of it; throws and catches
// what the library throws itself.
#include <dlfcn.h>
#include <girth/girth.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

int main(int, char** arguments) {
  void* plugin = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) {
    std::puts(dlerror());
    return 1;
  }
  const auto length = reinterpret_cast<double (*)()>(dlsym(plugin, "lengthOfLoop"));
  const auto open = reinterpret_cast<void (*)()>(dlsym(plugin, "openSurface"));
  if (!(std::fabs(length()) < 1e-9)) return 2;
  try {
    girth::Result<int>(girth::makeError(girth::ErrorCode::Internal, 5, "mine")).value();
    return 3;
  } catch (const girth::ThrownError& error) {
    if (error.element != 5) return 4;
  }
  try {
    open();
  } catch (const girth::Error& error) {
    std::printf("caught %s as girth::Error\n", std::string(girth::toString(error.code)).c_str());
  }
  try {
    open();
  } catch (const std::exception& error) {
    return std::string(error.what()).find("OPEN_EDGE: ") == 0 ? 0 : 5;
  }
  return 6;
}
