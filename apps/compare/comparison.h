#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/fly_all.h"
#include "apps/config/flight_request.h"
#include "apps/output/flight_summary.h"

namespace lineservo::apps {

/// Settings that differ between rows of one controller: "delta=50".
struct Variant {
  std::string label;
  std::vector<std::string> overrides;  ///< KEY=VALUE
};

/// What is flown on equal terms: every controller on every layout at every speed, all instructions.
struct Block {
  std::string title;  ///< which published figures stand beside it
  std::vector<std::string> controllers, instructions, layouts;
  std::vector<double> speeds_m_s;  ///< none: the conditions' speed
  bool own_speed = false;          ///< each controller at the speed that its paper flew
  std::vector<Variant> variants = {{}};
  std::vector<std::string> overrides;
};

/// The same block once for each floor that its instructions name by their zones (layout_of_zone), in the
/// order of their first instructions.
std::vector<Block> on_floors_of_zones(const Block& block);

enum class Tuning { published, tuned, both };

/// What is compared, under which conditions and how often.
struct ComparisonOptions {
  std::vector<Block> blocks;
  std::string conditions = "paper";
  Tuning tuning = Tuning::both;
  int runs = 10;
  std::uint64_t seed = 1;  ///< of the first run; run k flies with seed + k
  std::vector<std::string> overrides;
  std::optional<std::string> reference;  ///< none: ibvs, or the first controller when it does not fly
};

/// One row of the table: who flies with which parameters, where and how fast.
struct Entry {
  std::string group;  ///< entries of one group fly the same flights
  std::string title;
  std::string controller;
  bool tuned = false;
  Variant variant;
  std::string layout;
  std::vector<std::string> instructions;
  std::optional<double> asked_speed_m_s = {};  ///< none: that of the conditions
  double speed_m_s = 0.0;                      ///< NaN when each flight draws its own
  bool own_speed = false;
  std::vector<std::string> overrides;  ///< on top of conditions, speed and tuned parameters
  FlightRequest request;               ///< of its flights, but for instruction and seed

  /// "pid", "pid tuned", "improved-carrot delta=50".
  std::string label() const;
};

/// One flight of an entry and how it went.
struct ComparedFlight {
  std::string instruction;
  std::uint64_t seed = 0;
  std::string command;  ///< flies it again
  FlightSummary summary;
  std::optional<FlightTrace> trace = {};  ///< of the first run of each instruction
};

/// A row: an entry with its flights, in the order of instructions, then seeds.
struct Contestant {
  Entry entry;
  std::vector<ComparedFlight> flights;
};

/// What the memory of a small machine holds, and days of flying.
inline constexpr std::size_t kMostFlights = 100'000;

/// The rows that the options ask for, each ready to fly. Throws InputError or std::invalid_argument; also for
/// more than kMostFlights.
std::vector<Entry> entries_of(const ComparisonOptions& options);

/// A comparison made ready: every target is checked before the first flight.
class Comparison {
 public:
  /// Throws InputError or std::invalid_argument.
  explicit Comparison(const ComparisonOptions& options);

  std::size_t flights() const { return tasks_.size(); }
  /// Flies all of it on so many threads: all but the timings is the same for any number. None when `watch`,
  /// told how many flights are done, returned false.
  std::optional<std::vector<Contestant>> fly(int jobs, const std::function<bool(std::size_t done)>& watch);

 private:
  void add_flights(Contestant& contestant, const std::string& instruction, const ComparisonOptions& options);

  std::vector<Contestant> contestants_;
  std::deque<Mission> missions_;  ///< of every contestant and instruction, without the seed
  std::deque<Settings> drawn_;    ///< of every flight, where each has its own
  std::deque<FlightTrace> traces_;
  std::vector<FlightTask> tasks_;  ///< in the order of the contestants' flights
};

/// The controller that the others are held against.
std::string reference_of(const ComparisonOptions& options);

}  // namespace lineservo::apps
