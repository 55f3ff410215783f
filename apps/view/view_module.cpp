// The part of the program that links ViSP's windows and X11: a module that is loaded by the first --view.
// ViSP's headers are not valid C++20, so it is C++17.

#include <X11/Xlib.h>
#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpImage.h>
#include <visp3/gui/vpDisplayX.h>
#include <visp3/gui/vpPlot.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "apps/view/view_window.h"

namespace {

using lineservo::apps::PlotSample;
using lineservo::apps::ViewKey;
using lineservo::apps::ViewWindow;
using lineservo::apps::WindowSpec;
using lineservo::apps::WindowState;

/// A connection to a display broke in the call that throws it.
class ConnectionBroke : public std::runtime_error {
 public:
  ConnectionBroke() : std::runtime_error("the display is gone") {}
};

/// Xlib ends the program when its handler returns, whatever the handler says: so it must not return.
[[noreturn]] int on_io_error(Display*) {
  throw ConnectionBroke();
}

int on_error(Display*, XErrorEvent*) {
  return 0;  // of a single request: the picture is not shown, or not all of it
}

/// Colours of Okabe and Ito, which colour-blind readers tell apart.
const vpColor kBlue(0, 114, 178), kVermilion(213, 94, 0), kGreen(0, 158, 115), kSky(86, 180, 233),
    kOrange(230, 159, 0);

struct Curve {
  const char* legend;
  vpColor colour;
};

constexpr unsigned kFeatures = 0, kVelocities = 1;

/// A connection by itself. While it is held, a server that starts anew when its last client leaves stays as
/// it is.
class Connection {
 public:
  Connection() : display_(XOpenDisplay(nullptr)) {}
  ~Connection() {
    try {
      if (display_ != nullptr) XCloseDisplay(display_);
    } catch (const ConnectionBroke&) {  // it is gone either way
    }
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  bool is_there() const { return display_ != nullptr; }

 private:
  Display* display_;
};

bool answers() try { return Connection().is_there(); } catch (const ConnectionBroke&) {
  return false;
}

/// Windows of displays that are gone, as they are, until the program ends: tidying up would talk to the
/// display.
std::vector<const void*>& left_behind() {
  static auto* const windows = new std::vector<const void*>;
  return *windows;
}

/// A window of ViSP's with a connection of its own, which may break.
template <typename Window>
class Guarded {
 public:
  template <typename... Arguments>
  explicit Guarded(Arguments&&... arguments) : window_(new Window(std::forward<Arguments>(arguments)...)) {}
  ~Guarded() {
    use([](Window& window) { vpDisplay::flush(window.shown()); });  // notices when it broke since
    if (broke_) {
      left_behind().push_back(window_);
    } else {
      delete window_;
    }
  }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  bool broke() const { return broke_; }
  template <typename Use>
  void use(Use&& what) {
    if (broke_) return;
    try {
      what(*window_);
    } catch (const ConnectionBroke&) {
      broke_ = true;
    } catch (const vpException&) {
      broke_ = true;
    }
  }

 private:
  Window* window_;
  bool broke_ = false;
};

struct Picture {
  Picture(const WindowSpec& spec)
      : image(static_cast<unsigned>(spec.size.height), static_cast<unsigned>(spec.size.width)),
        display(image, 0, 0, spec.title) {}

  const vpImage<vpRGBa>& shown() const { return image; }

  vpImage<vpRGBa> image;
  vpDisplayX display;
};

struct Plots {
  Plots(const WindowSpec& spec)
      : plot(2, 640, 560, spec.size.width + 30, 0, spec.title + ": features and velocities") {
    init(kFeatures, "Features", "", 0.8,
         {{"line rho", kBlue}, {"line theta [rad]", kVermilion}, {"junction [m]", kGreen}});
    init(kVelocities, "Velocities", "", 0.4,
         {{"forward, commanded [m/s]", kBlue},
          {"left, commanded [m/s]", kVermilion},
          {"yaw, commanded [rad/s]", kGreen},
          {"forward, estimated [m/s]", kSky},
          {"left, estimated [m/s]", kOrange}});
  }

  void init(unsigned graph, const char* title, const char* unit, double range,
            const std::vector<Curve>& curves) {
    plot.initGraph(graph, static_cast<unsigned>(curves.size()));
    plot.initRange(graph, 0.0, 20.0, -range, range);
    plot.setTitle(graph, title);
    plot.setUnitX(graph, "s");
    plot.setUnitY(graph, unit);
    for (unsigned k = 0; k < curves.size(); ++k) {
      plot.setLegend(graph, k, curves[k].legend);
      plot.setColor(graph, k, curves[k].colour);
    }
  }

  template <std::size_t N>
  void add(unsigned graph, double time_s, const std::array<double, N>& values) {
    for (unsigned k = 0; k < N; ++k)
      if (std::isfinite(values[k])) plot.plot(graph, k, time_s, values[k]);
  }

  const vpImage<unsigned char>& shown() const { return plot.I; }

  vpPlot plot;
};

std::optional<ViewKey> key_of(const std::string& key) {
  if (key == " " || key == "space") return ViewKey::pause;
  if (key == "n" || key == "N") return ViewKey::step;
  if (key == "f" || key == "F") return ViewKey::fast;
  if (key == "q" || key == "Q" || key == "Escape" || key == "\033") return ViewKey::quit;
  return std::nullopt;
}

template <typename Image>
std::optional<ViewKey> pressed(const Image& image) {
  std::string key;
  while (vpDisplay::getKeyboardEvent(image, key, false))
    if (const auto known = key_of(key)) return known;
  return std::nullopt;
}

class VispWindow final : public ViewWindow {
 public:
  explicit VispWindow(const WindowSpec& spec) : picture_(spec), plots_(spec) {}

  void show(const cv::Mat& bgr) override {
    picture_.use([&](Picture& p) {
      const cv::Mat rgba(bgr.rows, bgr.cols, CV_8UC4, p.image.bitmap);
      cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
      vpDisplay::display(p.image);
      vpDisplay::flush(p.image);
    });
  }

  void plot(const PlotSample& sample) override {
    plots_.use([&](Plots& p) {
      p.add(kFeatures, sample.time_s, sample.features);
      p.add(kVelocities, sample.time_s, sample.velocities);
    });
  }

  std::optional<ViewKey> key() override {
    std::optional<ViewKey> key;
    picture_.use([&](Picture& p) { key = pressed(p.image); });
    if (!key) plots_.use([&](Plots& p) { key = pressed(p.plot.I); });
    return key;
  }

  // Window managers close a window of ViSP's by breaking its connection, as a display does that goes.
  WindowState state() const override {
    if (!picture_.broke()) return WindowState::open;
    return answers() ? WindowState::closed : WindowState::lost;
  }

 private:
  Guarded<Picture> picture_;
  Guarded<Plots> plots_;
};

std::string display_name() {
  const char* name = std::getenv("DISPLAY");
  return name == nullptr ? "" : name;
}

}  // namespace

/// The windows, which are the caller's own; none when there is no display, with the complaint.
extern "C" __attribute__((visibility("default"))) ViewWindow* lineservo_open_window(
    const WindowSpec* spec, std::string* complaint) noexcept try {
  XSetErrorHandler(on_error);
  XSetIOErrorHandler(on_io_error);
  if (display_name().empty()) {
    *complaint = "DISPLAY is not set";
    return nullptr;
  }
  const Connection held;
  if (!held.is_there()) {
    *complaint = "the display " + display_name() + " does not answer";
    return nullptr;
  }
  return new VispWindow(*spec);
} catch (const std::exception& fault) {
  *complaint = fault.what();
  return nullptr;
}
