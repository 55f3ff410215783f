#pragma once

// A display without a screen: Xvfb, and what a user does and sees on it. X11's macros are in the way of
// others: include it last.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <thread>

// clang-format off
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
// clang-format on

namespace lineservo::testing {

/// Xvfb in a process of its own, with DISPLAY set to it as long as it lives.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int number[2];
    if (::pipe(number) != 0) return;
    server_ = ::fork();
    if (server_ == 0) become_server(number[1]);
    ::close(number[1]);
    char digit = 0;
    std::string name;
    while (::read(number[0], &digit, 1) == 1 && digit != '\n') name += digit;
    ::close(number[0]);
    if (name.empty()) return;
    ::setenv("DISPLAY", (":" + name).c_str(), 1);
    display_ = XOpenDisplay(nullptr);
  }
  ~VirtualDisplay() {
    if (display_ != nullptr) XCloseDisplay(display_);
    end();
    ::unsetenv("DISPLAY");
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// Otherwise there is no Xvfb.
  bool is_up() const { return display_ != nullptr; }
  /// As a server ends that crashes.
  void crash() {
    XCloseDisplay(display_);
    display_ = nullptr;
    end();
  }

  /// A window by its title; waits for it up to 20 s.
  std::optional<Window> window(const std::string& title) const {
    std::optional<Window> found;
    wait_for([&] { return (found = search(DefaultRootWindow(display_), title)).has_value(); });
    return found;
  }
  void press(Window window, KeySym key) const {
    XEvent event{};
    XKeyEvent& pressed = event.xkey;
    pressed.type = KeyPress;
    pressed.display = display_;
    pressed.window = window;
    pressed.root = DefaultRootWindow(display_);
    pressed.same_screen = True;
    pressed.keycode = XKeysymToKeycode(display_, key);
    XSendEvent(display_, window, True, KeyPressMask, &event);
    XSync(display_, False);
  }
  /// As window managers close a window that knows no protocol.
  void close(Window window) const {
    XKillClient(display_, window);
    XSync(display_, False);
  }
  /// CV_8UC3, BGR.
  cv::Mat screenshot(Window window) const {
    XWindowAttributes look{};
    XGetWindowAttributes(display_, window, &look);
    XImage* image = XGetImage(display_, window, 0, 0, static_cast<unsigned>(look.width),
                              static_cast<unsigned>(look.height), AllPlanes, ZPixmap);
    cv::Mat bgr(look.height, look.width, CV_8UC3);
    for (int y = 0; y < bgr.rows; ++y) {
      for (int x = 0; x < bgr.cols; ++x) {
        const unsigned long rgb = XGetPixel(image, x, y);
        bgr.at<cv::Vec3b>(y, x) = {static_cast<uchar>(rgb), static_cast<uchar>(rgb >> 8),
                                   static_cast<uchar>(rgb >> 16)};
      }
    }
    XDestroyImage(image);
    return bgr;
  }

  /// True once it holds, within 20 s.
  static bool wait_for(const std::function<bool()>& holds) {
    for (int k = 0; k < 4000; ++k) {
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

 private:
  [[noreturn]] static void become_server(int tells) {
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, STDERR_FILENO);
    const std::string fd = std::to_string(tells);
    ::execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp",
             nullptr);
    ::_exit(127);
  }
  void end() {
    if (server_ <= 0) return;
    ::kill(server_, SIGKILL);
    ::waitpid(server_, nullptr, 0);
    server_ = 0;
  }
  std::optional<Window> search(Window top, const std::string& title) const {
    char* name = nullptr;
    if (XFetchName(display_, top, &name) != 0 && name != nullptr) {
      const bool is_it = name == title;
      XFree(name);
      if (is_it) return top;
    }
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display_, top, &root, &parent, &children, &count) == 0) return std::nullopt;
    std::optional<Window> found;
    for (unsigned k = 0; k < count && !found; ++k) found = search(children[k], title);
    if (children != nullptr) XFree(children);
    return found;
  }

  pid_t server_ = 0;
  Display* display_ = nullptr;
};

}  // namespace lineservo::testing
