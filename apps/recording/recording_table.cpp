#include "apps/recording/recording_table.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "apps/config/input_error.h"
#include "apps/config/text_file.h"
#include "apps/recording/tick_fields.h"

namespace lineservo::apps {
namespace {

std::string text(servo::Time value) {
  return fmt::format("{}", value.count());
}
std::string text(double value) {
  return fmt::format("{}", value);
}
std::string text(bool value) {
  return value ? "1" : "0";
}

/// The cells of a line, one after the other. Throws InputError behind `where`.
class Cells {
 public:
  Cells(std::string_view line, std::string where) : rest_(line), where_(std::move(where)) {}

  std::string next(const char* column) {
    if (is_over_) throw InputError(fmt::format("{}: column {} is missing", where_, column));
    const std::size_t comma = rest_.find(',');
    const std::string cell(rest_.substr(0, comma));
    is_over_ = comma == rest_.npos;
    rest_.remove_prefix(is_over_ ? rest_.size() : comma + 1);
    return cell;
  }
  void read(const char* column, double& value) { read_number(column, value); }
  void read(const char* column, servo::Time& value) {
    std::int64_t count = 0;
    read_number(column, count);
    value = servo::Time(count);
  }
  void read(const char* column, bool& value) {
    const std::string cell = next(column);
    if (cell != "0" && cell != "1")
      throw InputError(fmt::format("{}: {} '{}' must be 0 or 1", where_, column, cell));
    value = cell == "1";
  }
  void end() const {
    if (!is_over_) throw InputError(where_ + ": has more columns than its header");
  }

 private:
  template <typename Number>
  void read_number(const char* column, Number& value) {
    const std::string cell = next(column);
    const char* const last = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), last, value);
    if (error != std::errc{} || stop != last)
      throw InputError(fmt::format("{}: {} '{}' must be a number", where_, column, cell));
  }

  std::string_view rest_;
  std::string where_;
  bool is_over_ = false;
};

RecordedTick read_row(Cells cells, std::size_t controllers) {
  RecordedTick tick;
  for_each_field(tick.input, [&cells](const char* name, auto& value) { cells.read(name, value); });
  tick.estimates_sha256 = cells.next("estimates_sha256");
  tick.frame = cells.next("frame");
  tick.frame_sha256 = cells.next("frame_sha256");
  for (std::size_t k = 0; k < controllers; ++k) {
    RecordedOutput output;
    for (std::size_t c = 0; c < output.command.size(); ++c) cells.read(kCommandColumns[c], output.command[c]);
    output.command_sha256 = cells.next("command_sha256");
    output.features_sha256 = cells.next("features_sha256");
    tick.outputs.push_back(std::move(output));
  }
  cells.end();
  return tick;
}

}  // namespace

std::string recording_header(const std::vector<std::string>& controllers) {
  std::string header;
  const TickInput any;
  for_each_field(any, [&header](const char* name, const auto&) { header += fmt::format("{},", name); });
  header += "estimates_sha256,frame,frame_sha256";
  for (const std::string& controller : controllers) {
    for (const char* column : kCommandColumns) header += fmt::format(",{}.{}", controller, column);
    header += fmt::format(",{0}.command_sha256,{0}.features_sha256", controller);
  }
  return header + "\n";
}

std::string recording_row(const RecordedTick& tick) {
  std::string row;
  for_each_field(tick.input, [&row](const char*, const auto& value) { row += text(value) + ","; });
  row += fmt::format("{},{},{}", tick.estimates_sha256, tick.frame, tick.frame_sha256);
  for (const RecordedOutput& output : tick.outputs) {
    for (const double value : output.command) row += "," + text(value);
    row += fmt::format(",{},{}", output.command_sha256, output.features_sha256);
  }
  return row + "\n";
}

std::vector<RecordedTick> read_recording_table(const std::filesystem::path& file,
                                               const std::vector<std::string>& controllers) {
  const std::string content = read_bytes(file);
  const std::string header = recording_header(controllers);
  if (!content.starts_with(header))
    throw InputError(file.string() + ":1: is not the header of this recording");
  std::vector<RecordedTick> ticks;
  std::string_view rest = std::string_view(content).substr(header.size());
  for (std::size_t line = 2; !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    const std::string where = fmt::format("{}:{}", file.string(), line);
    if (end == rest.npos) throw InputError(where + ": the line is cut short");
    ticks.push_back(read_row({rest.substr(0, end), where}, controllers.size()));
    rest.remove_prefix(end + 1);
  }
  return ticks;
}

}  // namespace lineservo::apps
