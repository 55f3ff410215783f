#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lineservo::apps {

/// Figures of a paper, to stand beside the rows of a block of the same title.
struct PublishedRow {
  std::string_view title;   ///< of the block
  std::string_view who;     ///< the law, as its paper calls it
  std::string_view source;  ///< paper and table
  std::optional<double> junction_accuracy, rmse_m, max_m, mean_m, terminal_error_m, duration_s;
  std::string_view note;
};

nlohmann::ordered_json to_json(const PublishedRow& row);

/// Between which values a published figure lies over the flights of a paper.
struct PublishedRange {
  std::string_view metric;  ///< as in summary.json
  double low, high;
  std::string_view source;
};
const std::vector<PublishedRange>& published_ranges();

/// Those of a block; none for a block that no paper flew.
std::vector<PublishedRow> published_beside(const std::string& title);

}  // namespace lineservo::apps
