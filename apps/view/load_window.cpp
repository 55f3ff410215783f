#include "apps/view/load_window.h"

#include "apps/module/module_function.h"

namespace lineservo::apps {
namespace {

using Open = ViewWindow* (*)(const WindowSpec* spec, std::string* complaint);

}  // namespace

std::unique_ptr<ViewWindow> load_window(const WindowSpec& spec, std::string& complaint) {
  static const Open open =
      module_function<Open>("liblineservo_view_module.so", "lineservo_open_window", "windows");
  return std::unique_ptr<ViewWindow>(open(&spec, &complaint));
}

}  // namespace lineservo::apps
