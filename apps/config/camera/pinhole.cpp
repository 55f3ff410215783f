#include "apps/config/camera/pinhole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lineservo::apps {
namespace {

constexpr char kHeld[] = "only a pinhole with k1, k2, p1, p2 and k3 can be used";

// Optimisers leave a skew of rounding errors behind.
bool is_pinhole(const std::vector<double>& k) {
  const double small = 1e-9 * std::max(k[0], k[4]);
  return k[0] > 0.0 && k[4] > 0.0 && std::abs(k[1]) <= small && std::abs(k[3]) <= small && k[6] == 0.0 &&
         k[7] == 0.0 && k[8] == 1.0;
}

}  // namespace

void take_matrix(const CameraEntries& entries, const Spellings& keys, features::CameraParameters& camera) {
  const std::vector<double> k = entries.numbers(keys);
  if (k.size() != 9) entries.fail(entries.at(keys), "must be 3 by 3 numbers");
  if (!is_pinhole(k))
    entries.fail(entries.at(keys), "must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy above 0 and no skew");
  camera.fx_px = k[0];
  camera.fy_px = k[4];
  camera.cx_px = k[2];
  camera.cy_px = k[5];
}

void take_lens(const CameraEntries& entries, const Spellings& keys, features::CameraParameters& camera) {
  const CameraEntry& entry = entries.at(keys);
  const std::vector<double> terms = entries.numbers(keys);
  const std::size_t lengths[] = {0, 4, 5, 8, 12, 14};
  if (std::find(std::begin(lengths), std::end(lengths), terms.size()) == std::end(lengths))
    entries.fail(entry, fmt::format("has {} numbers, must have 4, 5, 8, 12 or 14", terms.size()));
  const std::size_t held = std::min(terms.size(), camera.distortion.size());
  for (std::size_t k = held; k < terms.size(); ++k)
    if (terms[k] != 0.0)
      entries.fail(entry, fmt::format("number {} is {}, not 0: {}", k + 1, terms[k], kHeld));
  std::copy_n(terms.begin(), held, camera.distortion.begin());
}

void refuse_lens(const CameraEntries& entries, const CameraEntry& entry) {
  const std::string model = entry.words.empty() ? "" : entry.words.front();
  entries.fail(entry, fmt::format("the lens model '{}' is refused: {}", model, kHeld));
}

}  // namespace lineservo::apps
