#include "apps/grabber/load_grabbers.h"

#include <dlfcn.h>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

using Open = vehicle::FrameSource* (*)(const std::string* name, const vehicle::GrabberOptions* options,
                                       std::string* complaint);

Open load_module() {
  void* module = ::dlopen("liblineservo_grabber_module.so", RTLD_NOW | RTLD_LOCAL);
  void* symbol = module == nullptr ? nullptr : ::dlsym(module, "lineservo_open_source");
  if (symbol == nullptr) throw std::runtime_error(std::string("the grabbers do not load: ") + ::dlerror());
  return reinterpret_cast<Open>(symbol);
}

}  // namespace

std::unique_ptr<vehicle::FrameSource> load_source(const std::string& name,
                                                  const vehicle::GrabberOptions& options) {
  static const Open open = load_module();
  std::string complaint;
  std::unique_ptr<vehicle::FrameSource> source(open(&name, &options, &complaint));
  if (!source) throw InputError(complaint);
  return source;
}

}  // namespace lineservo::apps
