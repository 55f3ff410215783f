#include "features/line/border_points.h"

#include <bit>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

// How far a border may move from one scan line to the next, in strides: past it the other family sees it.
constexpr int kRowReach = 2;
constexpr int kColumnReach = 3;
constexpr int kSmoothingLinks = 2;  // the direction is taken over so many links each way

// atan(z) ≈ z (π/4 + 0.273 (1 − |z|)) for |z| ≤ 1, to 0.22°.
double coarse_atan(double z) {
  return z * (kPi / 4.0 + 0.273 * (1.0 - std::abs(z)));
}

// atan(y/x), or ±π/2 − atan(x/y) where that is the smaller. Without branches: worn paint looks every way.
double coarse_axis_angle(const Eigen::Vector2d& n) {
  const int steep = int{std::abs(n.y()) > std::abs(n.x())};
  const double from_axis = coarse_atan(n[1 - steep] / n[steep]);
  return steep * std::copysign(kPi / 2.0, from_axis) + (1 - 2 * steep) * from_axis;
}

}  // namespace

BorderExtractor::BorderExtractor(const BorderOptions& options) : options_(options) {
  const int s = options.stride_px;
  if (s != 1 && s != 2 && s != 4 && s != 8)
    throw std::invalid_argument("border stride must be 1, 2, 4 or 8 px");
  if (options.max_crossings_a_line < 2 || options.max_crossings_a_line > 1024)
    throw std::invalid_argument("border crossings a line must be 2 to 1024");
  if (options.min_links < 1 || options.min_links > 2 * kSmoothingLinks)
    throw std::invalid_argument("border links must be 1 to 4");
}

void BorderExtractor::extract(const LevelMask& mask, std::vector<BorderPoint>& points) {
  points.clear();
  const int stride = options_.stride_px;
  scan_rows(mask.mask());
  scan_columns(mask.mask());
  flatten(rows_);
  flatten(columns_);
  link(rows_, kRowReach * stride);
  link(columns_, kColumnReach * stride);
  const MaskGeometry& geometry = mask.geometry();
  const auto place = [](Family& family, auto&& at) {
    for (std::size_t line = 0; line + 1 < family.first.size(); ++line)
      for (int i = family.first[line]; i < family.first[line + 1]; ++i) {
        Crossing& crossing = family.crossings[static_cast<std::size_t>(i)];
        crossing.p_L = at(static_cast<int>(line), crossing.position_px);
      }
  };
  place(rows_,
        [&](int line, int x) { return mask.level(geometry.left_border(x, line * stride + stride / 2)); });
  place(columns_,
        [&](int line, int y) { return mask.level(geometry.top_border(line * stride + stride / 2, y)); });
  emit(rows_, 1, stride * geometry.pinhole_inverse()(1, 1), points);
  emit(columns_, 0, stride * geometry.pinhole_inverse()(0, 0), points);
}

void BorderExtractor::reset(Family& family, int lines) const {
  family.raw.resize(static_cast<std::size_t>(lines) *
                    static_cast<std::size_t>(options_.max_crossings_a_line));
  family.count.assign(static_cast<std::size_t>(lines), 0);
}

void BorderExtractor::add(Family& family, int line, int position_px, bool into_paint) const {
  int& count = family.count[static_cast<std::size_t>(line)];
  if (count < options_.max_crossings_a_line)
    family.raw[static_cast<std::size_t>(line * options_.max_crossings_a_line + count)] =
        static_cast<std::uint16_t>(position_px * 2 + int{into_paint});
  ++count;
}

// A pixel toggles against its left neighbour where w XOR (w << 1) is set; the first pixel has no neighbour.
void BorderExtractor::scan_rows(const MaskView& mask) {
  const int stride = options_.stride_px;
  reset(rows_, mask.height / stride);
  for (int line = 0; line < mask.height / stride; ++line) {
    const std::uint64_t* row = mask.row(line * stride + stride / 2);
    std::uint64_t carry = row[0] & 1u;
    for (int word = 0; word < mask.words_per_row; ++word) {
      std::uint64_t toggles = row[word] ^ ((row[word] << 1) | carry);
      carry = row[word] >> 63;
      for (; toggles != 0; toggles &= toggles - 1) {
        const int bit = std::countr_zero(toggles);
        const int x = word * 64 + bit;
        if (x < mask.width) add(rows_, line, x, (row[word] >> bit) & 1u);
      }
    }
  }
}

void BorderExtractor::scan_columns(const MaskView& mask) {
  const int stride = options_.stride_px;
  const int lines = mask.width / stride, stride_bits = std::countr_zero(static_cast<unsigned>(stride));
  reset(columns_, lines);
  std::uint64_t scanned = 0;
  for (int bit = stride / 2; bit < 64; bit += stride) scanned |= std::uint64_t{1} << bit;
  for (int y = 1; y < mask.height; ++y) {
    const std::uint64_t* row = mask.row(y);
    const std::uint64_t* above = mask.row(y - 1);
    for (int word = 0; word < mask.words_per_row; ++word) {
      std::uint64_t toggles = (row[word] ^ above[word]) & scanned;
      for (; toggles != 0; toggles &= toggles - 1) {
        const int bit = std::countr_zero(toggles);
        const int line = (word * 64 + bit) >> stride_bits;
        if (line < lines) add(columns_, line, y, (row[word] >> bit) & 1u);
      }
    }
  }
}

void BorderExtractor::flatten(Family& family) const {
  family.crossings.clear();
  family.first.clear();
  for (std::size_t line = 0; line < family.count.size(); ++line) {
    family.first.push_back(static_cast<int>(family.crossings.size()));
    if (family.count[line] > options_.max_crossings_a_line) continue;
    const std::uint16_t* raw = &family.raw[line * static_cast<std::size_t>(options_.max_crossings_a_line)];
    for (int i = 0; i < family.count[line]; ++i) {
      const int self = static_cast<int>(family.crossings.size());
      family.crossings.push_back(
          {.position_px = raw[i] >> 1, .into_paint = (raw[i] & 1) != 0, .previous = self, .next = self});
    }
  }
  family.first.push_back(static_cast<int>(family.crossings.size()));
}

// Each crossing goes on to the nearest one of its kind on the next line, when that is within reach.
void BorderExtractor::link(Family& family, int reach_px) {
  for (std::size_t line = 0; line + 2 < family.first.size(); ++line) {
    int from = family.first[line + 1];
    const int end = family.first[line + 2];
    for (int i = family.first[line]; i < family.first[line + 1]; ++i) {
      Crossing& crossing = family.crossings[static_cast<std::size_t>(i)];
      int nearest_px = reach_px + 1;
      for (int j = from; j < end; ++j) {
        const Crossing& other = family.crossings[static_cast<std::size_t>(j)];
        const int step_px = other.position_px - crossing.position_px;
        if (step_px < -reach_px) from = j + 1;
        if (step_px > reach_px) break;
        if (other.into_paint != crossing.into_paint || std::abs(step_px) >= nearest_px) continue;
        nearest_px = std::abs(step_px);
        crossing.next = j;
      }
      if (crossing.next != i) family.crossings[static_cast<std::size_t>(crossing.next)].previous = i;
    }
  }
}

// A border of length ℓ at angle φ to the scan lines' normal is crossed ℓ |cos φ| / spacing times by one
// family and ℓ |sin φ| / spacing times by the other. A crossing that stands for spacing · |cos φ| (or |sin
// φ|) makes the sum over both ℓ cos²φ + ℓ sin²φ = ℓ at any angle.
void BorderExtractor::emit(const Family& family, int axis, double spacing,
                           std::vector<BorderPoint>& points) const {
  const auto at = [&](int i) -> const Crossing& { return family.crossings[static_cast<std::size_t>(i)]; };
  for (const Crossing& crossing : family.crossings) {
    const Crossing *from = &crossing, *to = &crossing;
    int links = 0;
    for (int k = 0; k < kSmoothingLinks; ++k) {
      const Crossing *before = &at(from->previous), *after = &at(to->next);
      links += int{before != from} + int{after != to};
      from = before;
      to = after;
    }
    if (links < options_.min_links) continue;
    const Eigen::Vector2d along = (to->p_L - from->p_L).normalized();
    // Scanning a row (axis 1) the tangent points down and paint on the right means a normal towards +x.
    const double turn = 2 * int{crossing.into_paint == (axis == 1)} - 1;
    const Eigen::Vector2d normal = turn * Eigen::Vector2d(along.y(), -along.x());
    points.push_back({crossing.p_L, normal, coarse_axis_angle(normal), spacing * std::abs(along[axis])});
  }
}

}  // namespace lineservo::features
