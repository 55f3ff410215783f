// In a file of its own: Xlib's inner header, the only one that tells which connections ViSP has opened, has
// macros that are in the way of C++.
#include "apps/view/x_connections.h"

#include <X11/Xlibint.h>

extern "C" Display* _XHeadOfDisplayList;

namespace {

void (*on_broken)() = nullptr;

void note(Display*, void*) {
  on_broken();
}

// Else Xlib prints a line of its own.
int say_nothing(Display*) {
  return 0;
}

}  // namespace

void survive_broken_connections(void (*broke)()) {
  on_broken = broke;
  XSetIOErrorHandler(say_nothing);
  for (Display* display = _XHeadOfDisplayList; display != nullptr; display = display->next)
    XSetIOErrorExitHandler(display, note, nullptr);
}
