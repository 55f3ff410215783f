#include "apps/compare/presets.h"

#include <fmt/format.h>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr double kTopologySpeed_m_s = 0.1;
constexpr double kHoverSpeed_m_s = 0.1;
constexpr double kPursuitSpeeds_m_s[] = {0.1, 0.2};
// About what the pitch of lfpf §4.1.1 comes to here: -0.19 deg (LFPF), -1 deg (improved carrot chasing).
constexpr double kSlow_m_s = 0.09, kFast_m_s = 0.46;

Block block(std::string title, std::vector<std::string> controllers, std::vector<std::string> instructions,
            std::vector<std::string> layouts) {
  Block b;
  b.title = std::move(title);
  b.controllers = std::move(controllers);
  b.instructions = std::move(instructions);
  b.layouts = std::move(layouts);
  return b;
}

Block at_speeds(Block b, std::vector<double> speeds_m_s) {
  b.speeds_m_s = std::move(speeds_m_s);
  return b;
}

Block at_own_speed(Block b) {
  b.own_speed = true;
  return b;
}

/// topology Tab. 2 to 4: each instruction by itself, as there.
std::vector<Block> topology_blocks() {
  std::vector<Block> blocks;
  for (const char* instruction : {"a03", "a13", "a23", "a53"})
    blocks.push_back(
        at_speeds(block(instruction, {"pid", "ibvs"}, {instruction}, {"warehouse"}), {kTopologySpeed_m_s}));
  return blocks;
}

/// lfpf §4.1: straight and bend at equal speed and at each law's own, and Fig. 9a's sweep of δ.
std::vector<Block> lfpf_blocks() {
  const std::vector<std::string> laws = {"carrot", "improved-carrot", "lfpf", "ibvs"};
  std::vector<Block> blocks;
  for (const char* track : {"straight", "bend"}) {
    blocks.push_back(at_speeds(block(track, laws, {"node:end"}, {track}), {kSlow_m_s, kFast_m_s}));
    blocks.push_back(at_own_speed(block(track, laws, {"node:end"}, {track})));
  }
  Block sweep = at_own_speed(block("delta sweep", {"improved-carrot"}, {"node:end"}, {"bend"}));
  sweep.variants.clear();
  for (const int delta_px : {50, 75, 100, 125, 150}) {
    sweep.variants.push_back(
        {fmt::format("delta={}", delta_px), {fmt::format("servo.improved-carrot.delta_px={}", delta_px)}});
  }
  blocks.push_back(sweep);
  return blocks;
}

/// grid §V and VI: to a node nearby, and 20 s above it.
std::vector<Block> grid_flight_blocks() {
  Block b = block("hover", {"grid", "ibvs"}, {"a01", "a11"}, {"warehouse", "tape-warehouse"});
  b.overrides = {"executive.hover_s=20"};
  return {at_speeds(b, {kHoverSpeed_m_s})};
}

/// vtp §2: along the red track, landing on its end; at equal speeds and at the pace of its own steps.
std::vector<Block> vtp_blocks() {
  const Block b = block("minidrone", {"vtp", "ibvs"}, {"node:end"}, {"minidrone"});
  return {at_speeds(b, {std::begin(kPursuitSpeeds_m_s), std::end(kPursuitSpeeds_m_s)}), at_own_speed(b)};
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kPresets = {
      {"topology", "a03, a13, a23, a53 on warehouse at 0.1 m/s", topology_blocks()},
      {"lfpf", "straight and bend, the sweep of delta, the distribution of errors", lfpf_blocks(), "paper",
       true},
      {"grid-flight", "a node nearby and 20 s above it", grid_flight_blocks()},
      {"vtp", "the red track to its end disc, and landing on it", vtp_blocks(), "minidrone"},
  };
  return kPresets;
}

const Preset& find_preset(const std::string& name) {
  std::string names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset;
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw InputError(fmt::format("--preset {}: there is no such preset; there are: {}", name, names));
}

}  // namespace lineservo::apps
