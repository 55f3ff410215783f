#include "apps/grabber/load_grabbers.h"

#include "apps/config/input_error.h"
#include "apps/module/module_function.h"

namespace lineservo::apps {
namespace {

using Open = vehicle::FrameSource* (*)(const std::string* name, const vehicle::GrabberOptions* options,
                                       std::string* complaint);

}  // namespace

std::unique_ptr<vehicle::FrameSource> load_source(const std::string& name,
                                                  const vehicle::GrabberOptions& options) {
  static const Open open =
      module_function<Open>("liblineservo_grabber_module.so", "lineservo_open_source", "grabbers");
  std::string complaint;
  std::unique_ptr<vehicle::FrameSource> source(open(&name, &options, &complaint));
  if (!source) throw InputError(complaint);
  return source;
}

}  // namespace lineservo::apps
