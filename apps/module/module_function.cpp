#include "apps/module/module_function.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace lineservo::apps {

void* module_symbol(const char* module, const char* symbol, const char* what) {
  void* const handle = ::dlopen(module, RTLD_NOW | RTLD_LOCAL);
  void* const found = handle == nullptr ? nullptr : ::dlsym(handle, symbol);
  if (found == nullptr) throw std::runtime_error(fmt::format("the {} do not load: {}", what, ::dlerror()));
  return found;
}

}  // namespace lineservo::apps
