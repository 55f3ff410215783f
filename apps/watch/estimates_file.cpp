#include "apps/watch/estimates_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "apps/config/input_error.h"
#include "apps/config/numbers.h"
#include "apps/config/settings_table.h"
#include "apps/config/text_file.h"
#include "servo/law/odometry.h"
#include "vehicle/time.h"

namespace lineservo::apps {
namespace {

constexpr double kHighest_m = 100.0;
constexpr double kLatest_s = 1e8;
constexpr double kLargest = 1e6;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // as spreadsheets begin their UTF-8

enum Column { t_s, height, roll, pitch, yaw, forward, left, up, kColumns };
constexpr std::array<const char*, kColumns> kNames = {"t_s",     "height_m",    "roll_rad", "pitch_rad",
                                                      "yaw_rad", "forward_m_s", "left_m_s", "up_m_s"};
constexpr std::array<NumberRange, kColumns> kBounds = {{{0.0, kLatest_s},
                                                        {kLowestHeight_m, kHighest_m},
                                                        {-1.5, 1.5},
                                                        {-1.5, 1.5},
                                                        {-kLargest, kLargest},
                                                        {-kLargest, kLargest},
                                                        {-kLargest, kLargest},
                                                        {-kLargest, kLargest}}};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(at, begin);
    parts.push_back(text.substr(begin, end - begin));
  }
  return parts;
}

/// Where each of our columns stands in the file's rows.
using Places = std::array<std::optional<std::size_t>, kColumns>;

Places places_of(const std::vector<std::string>& header, const std::string& where) {
  Places places;
  for (std::size_t k = 0; k < header.size(); ++k) {
    const auto it = std::find(kNames.begin(), kNames.end(), header[k]);
    if (it == kNames.end())
      throw InputError(
          fmt::format("{}: unknown column '{}'; allowed: {}", where, header[k], fmt::join(kNames, ", ")));
    std::optional<std::size_t>& place = places[static_cast<std::size_t>(it - kNames.begin())];
    if (place) throw InputError(fmt::format("{}: column '{}' is there twice", where, header[k]));
    place = k;
  }
  for (const Column needed : {t_s, height})
    if (!places[needed])
      throw InputError(
          fmt::format("{}: the header must name t_s and height_m; {} is missing", where, kNames[needed]));
  return places;
}

std::array<double, kColumns> values_of(const std::vector<std::string>& cells, const Places& places,
                                       const std::string& where) {
  std::array<double, kColumns> values{};
  for (std::size_t c = 0; c < kColumns; ++c) {
    if (!places[c]) continue;
    const std::string cell = *places[c] < cells.size() ? cells[*places[c]] : "";
    const auto value = parse_number(cell, kBounds[c].low, kBounds[c].high);
    if (!value)
      throw InputError(fmt::format("{}: {} '{}' must be a number from {} to {}", where, kNames[c], cell,
                                   kBounds[c].low, kBounds[c].high));
    values[c] = *value;
  }
  return values;
}

/// Rows one after the other, the odometry integrated along them.
class Rows {
 public:
  void add(const std::array<double, kColumns>& v, const std::string& where) {
    EstimateAt e;
    e.t = vehicle::from_seconds(v[t_s]);
    if (!rows_.empty() && e.t <= rows_.back().t)
      throw InputError(fmt::format("{}: t_s must be greater than in the row before", where));
    e.height_m = v[height];
    e.roll_rad = v[roll];
    e.pitch_rad = v[pitch];
    e.v_H_m_s = {v[forward], v[left], v[up]};
    odometry_.add(e.t, e.v_H_m_s.head<2>(), v[yaw]);
    e.odometry = odometry_.at(e.t);
    rows_.push_back(e);
  }
  std::vector<EstimateAt> take() { return std::move(rows_); }

 private:
  std::vector<EstimateAt> rows_;
  servo::Odometry odometry_;
};

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::string text = read_bytes(file);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  std::vector<std::string> lines = split(text, '\n');
  for (std::string& line : lines)
    if (line.ends_with('\r')) line.pop_back();
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace

Estimates read_estimates(const std::filesystem::path& file) {
  const std::vector<std::string> lines = lines_of(file);
  if (lines.size() < 2) throw InputError(file.string() + ": must have a header and at least one row");
  const std::vector<std::string> header = split(lines.front(), ',');
  const Places places = places_of(header, file.string() + ":1");
  Rows rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::string where = fmt::format("{}:{}", file.string(), k + 1);
    const std::vector<std::string> cells = split(lines[k], ',');
    if (cells.size() > header.size()) throw InputError(where + ": has more columns than its header");
    rows.add(values_of(cells, places, where), where);
  }
  return {rows.take(), file.string()};
}

}  // namespace lineservo::apps
