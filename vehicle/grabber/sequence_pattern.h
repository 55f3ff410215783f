#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lineservo::vehicle {

/// The path of numbered images: one %d or %04d (at most 9 digits) in the file's name, and no other %.
class SequencePattern {
 public:
  /// Throws GrabberError for anything else: the pattern goes to a printf in the end.
  explicit SequencePattern(const std::string& pattern);

  /// The same for a printf that is given a long: %04ld.
  std::string for_long() const;
  /// The numbers of the files that are there, in order.
  std::vector<long> numbers() const;

 private:
  std::optional<long> number_of(const std::string& file_name) const;

  std::string before_, after_;  ///< the %d, after_ within the file's name
  std::string width_;           ///< "04" of %04d
};

}  // namespace lineservo::vehicle
