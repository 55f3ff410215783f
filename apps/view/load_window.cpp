#include "apps/view/load_window.h"

#include <dlfcn.h>

#include <stdexcept>

namespace lineservo::apps {
namespace {

using Open = ViewWindow* (*)(const WindowSpec* spec, std::string* complaint);

Open load_module() {
  void* module = ::dlopen("liblineservo_view_module.so", RTLD_NOW | RTLD_LOCAL);
  void* symbol = module == nullptr ? nullptr : ::dlsym(module, "lineservo_open_window");
  if (symbol == nullptr) throw std::runtime_error(std::string("the windows do not load: ") + ::dlerror());
  return reinterpret_cast<Open>(symbol);
}

}  // namespace

std::unique_ptr<ViewWindow> load_window(const WindowSpec& spec, std::string& complaint) {
  static const Open open = load_module();
  return std::unique_ptr<ViewWindow>(open(&spec, &complaint));
}

}  // namespace lineservo::apps
