#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/evaluate/junction_study.h"

namespace lineservo::apps {

/// One study: a layout and how the camera was carried.
struct JunctionCase {
  std::string layout;
  JunctionStudyOptions options;
  std::vector<RecogniserScore> scores;
};

/// The cases of `evaluate junctions`: both warehouse layouts against yaw jitter, tilt and blur.
std::vector<JunctionCase> junction_cases(std::uint64_t seed);

/// Runs every case; `progress` is told before each.
void run(std::vector<JunctionCase>& cases,
         const std::function<void(std::size_t done, std::size_t all)>& progress);

/// A table for the terminal, the published figures in it.
std::string junction_table(const std::vector<JunctionCase>& cases);
nlohmann::ordered_json junction_json(const std::vector<JunctionCase>& cases);
std::string junction_csv(const std::vector<JunctionCase>& cases);

}  // namespace lineservo::apps
