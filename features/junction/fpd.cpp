#include "features/junction/fpd.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace lineservo::features {
namespace {

// round(1000 a / b), halves to the even number
int permille(std::int64_t a, std::int64_t b) {
  const std::int64_t whole = 1000 * a / b, twice_rest = 2 * (1000 * a % b);
  const bool up = twice_rest > b || (twice_rest == b && whole % 2 != 0);
  return static_cast<int>(whole + (up ? 1 : 0));
}

// lines: foreground pixels in each column (or row), each of which is line_length pixels long.
Densities_permille densities(const std::vector<int>& lines, std::size_t line_length) {
  Densities_permille result;
  const auto n = static_cast<std::ptrdiff_t>(lines.size());
  for (std::ptrdiff_t k = 0; k < kDensityBins; ++k) {
    const std::ptrdiff_t begin = k * n / kDensityBins, end = (k + 1) * n / kDensityBins;
    const int foreground = std::accumulate(lines.begin() + begin, lines.begin() + end, 0);
    result[static_cast<std::size_t>(k)] =
        permille(foreground, (end - begin) * static_cast<std::int64_t>(line_length));
  }
  return result;
}

// One run of similar bins, of which only those that are not empty count.
class Run {
 public:
  void add(int density) {
    if (density == 0) return;
    sum_ += density;
    ++bins_;
  }
  bool is_cluster() const { return bins_ >= 2; }
  double mean() const { return static_cast<double>(sum_) / bins_; }

 private:
  int sum_ = 0;
  int bins_ = 0;
};

}  // namespace

PixelDensities pixel_densities(const MaskProfile& profile) {
  if (profile.columns.size() < kDensityBins || profile.rows.size() < kDensityBins)
    throw std::invalid_argument("densities: the mask must measure at least 40x40 px");
  return {densities(profile.columns, profile.rows.size()), densities(profile.rows, profile.columns.size())};
}

std::vector<double> cluster_means_permille(std::span<const int> densities_permille) {
  std::vector<double> means;
  Run run;
  const auto close = [&] {
    if (run.is_cluster()) means.push_back(run.mean());
    run = Run{};
  };
  for (std::size_t i = 0; i < densities_permille.size(); ++i) {
    const bool joins =
        i > 0 && std::abs(densities_permille[i] - densities_permille[i - 1]) < kClusterGap_permille;
    if (!joins) close();
    run.add(densities_permille[i]);
  }
  close();
  return means;
}

Trend trend_of(std::span<const double> means) {
  if (means.empty()) return Trend::none;
  std::vector<bool> rises;  // one entry a step
  for (std::size_t i = 1; i < means.size(); ++i)
    if (std::abs(means[i] - means[i - 1]) >= kClusterGap_permille) rises.push_back(means[i] > means[i - 1]);
  if (rises.empty()) return Trend::constant;
  if (rises.size() == 1) return rises[0] ? Trend::rising : Trend::falling;
  return rises.size() == 2 && rises[0] && !rises[1] ? Trend::rising_falling : Trend::other;
}

JunctionCode code_of(Trend columns, Trend rows) {
  const bool one_step = rows == Trend::rising || rows == Trend::falling;
  const bool peak = rows == Trend::rising_falling;
  switch (columns) {
    case Trend::none:
    case Trend::constant:
      return rows == Trend::constant ? JunctionCode::straight : JunctionCode::unrecognised;
    case Trend::falling:
      return peak       ? JunctionCode::tee_right
             : one_step ? JunctionCode::corner_right
                        : JunctionCode::unrecognised;
    case Trend::rising:
      return peak       ? JunctionCode::tee_left
             : one_step ? JunctionCode::corner_left
                        : JunctionCode::unrecognised;
    case Trend::rising_falling:
      if (peak) return JunctionCode::cross;
      if (!one_step) return JunctionCode::unrecognised;
      return rows == Trend::rising ? JunctionCode::tee_behind : JunctionCode::tee_ahead;
    case Trend::other:
      break;
  }
  return JunctionCode::unrecognised;
}

bool line_ends_ahead(const PixelDensities& densities) {
  const auto first = std::find_if(densities.rows.begin(), densities.rows.end(), [](int d) { return d != 0; });
  return first != densities.rows.end() && first - densities.rows.begin() >= kEmptyBinsBeyondLineEnd;
}

DensityReading read_densities(const PixelDensities& densities, int marker_pixels) {
  const bool ends = line_ends_ahead(densities);
  if (marker_pixels > kStartMarkerLimit_px) return {JunctionCode::start, ends};
  const Trend columns = trend_of(cluster_means_permille(densities.columns));
  const Trend rows = trend_of(cluster_means_permille(densities.rows));
  return {code_of(columns, rows), ends};
}

}  // namespace lineservo::features
