#include "apps/recording/digest.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "apps/output/sha256.h"
#include "apps/recording/tick_fields.h"

namespace lineservo::apps {
namespace {

using namespace features;

/// The values one after the other. What may be absent goes behind the count of its values.
class Bytes {
 public:
  void add(double value) {
    if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
    append(&value, sizeof value);
  }
  void add(std::int64_t value) { append(&value, sizeof value); }
  void add(int value) { add(std::int64_t{value}); }
  void add(std::size_t value) { add(static_cast<std::int64_t>(value)); }
  void add(bool value) { add(std::int64_t{value}); }
  void add(servo::Time value) { add(std::int64_t{value.count()}); }
  void add(JunctionCode code) { add(std::int64_t{static_cast<int>(code)}); }
  void add(const LevelPoint& p) { add_all(p.x, p.y); }
  void add(const PixelPoint& p) { add_all(p.x, p.y); }
  void add(const Eigen::Matrix2d& m) { add_all(m(0, 0), m(0, 1), m(1, 0), m(1, 1)); }
  void add(const ArmFeature& arm) { add_all(arm.angle_rad, arm.length); }
  void add(const LineFeature& l) {
    add_all(l.rho, l.theta_rad, l.covariance, l.width, l.quality, l.begin, l.end, l.curvature);
  }
  void add(const JunctionFeature& j) { add_all(j.centre, j.covariance, j.arms, j.quality); }
  void add(const CodeReading& code) { add_all(code.raw, code.held, code.smoothed, code.line_ends_ahead); }
  void add(const LawFeatures& law) { add_all(law.centroid, law.lines, law.ahead, law.behind, law.target); }
  template <typename T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <typename T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
  }
  template <typename... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

  std::string digest() const { return sha256_hex(bytes_); }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

}  // namespace

std::string digest(const TickInput& input) {
  Bytes bytes;
  for_each_field(input, [&bytes](const char*, const auto& value) { bytes.add(value); });
  return bytes.digest();
}

std::string digest(const FrameFeatures& f) {
  Bytes bytes;
  bytes.add_all(f.lines, f.junction, f.code, f.line_end, f.centroid_px, f.marker_pixels, f.start_marker,
                f.foreground_ratio, f.law);
  return bytes.digest();
}

std::string digest(const CommandRow& command) {
  Bytes bytes;
  for (const double value : command) bytes.add(value);
  return bytes.digest();
}

}  // namespace lineservo::apps
