#include "apps/compare/comparison_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "apps/compare/metrics.h"
#include "apps/compare/published.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}
ordered_json interval(const Interval& i) {
  return {number(i.low), number(i.high)};
}

std::string_view name(Tuning tuning) {
  return tuning == Tuning::both ? "both" : tuning == Tuning::tuned ? "tuned" : "published";
}

ordered_json json_of(const Block& b) {
  ordered_json json = {
      {"title", b.title},     {"controllers", b.controllers}, {"instructions", b.instructions},
      {"layouts", b.layouts}, {"speeds_m_s", b.speeds_m_s},   {"own_speed", b.own_speed},
      {"set", b.overrides}};
  json["variants"] = ordered_json::array();
  for (const Variant& v : b.variants) json["variants"].push_back({{"label", v.label}, {"set", v.overrides}});
  return json;
}

ordered_json settings_json(const ComparisonResult& result) {
  const ComparisonOptions& o = result.options;
  ordered_json json = {
      {"version", kVersion},
      {"preset", result.preset.empty() ? ordered_json(nullptr) : ordered_json(result.preset)},
      {"conditions", o.conditions},
      {"tuning", name(o.tuning)},
      {"runs", o.runs},
      {"seed", o.seed},
      {"set", o.overrides},
      {"reference", reference_of(o)}};
  json["blocks"] = ordered_json::array();
  for (const Block& block : o.blocks) json["blocks"].push_back(json_of(block));
  return json;
}

/// What tells a row from the others.
ordered_json identity_json(const Entry& e) {
  return {{"title", e.title},           {"layout", e.layout},       {"instructions", e.instructions},
          {"variant", e.variant.label}, {"speed_m_s", e.speed_m_s}, {"own_speed", e.own_speed}};
}

ordered_json json_of(const Contestant& c) {
  const Standing s = standing_of(c);
  ordered_json json = {{"name", c.entry.controller},
                       {"tuned", c.entry.tuned},
                       {"adaptations", servo::find_controller(c.entry.controller).adaptations}};
  json.update(identity_json(c.entry));
  json.update({{"runs", s.runs},
               {"arrived", s.arrived},
               {"success_rate", s.success_rate()},
               {"success_ci95", interval(s.success_ci95)},
               {"tracked", s.tracked},
               {"outcomes", s.outcomes}});
  for (const Metric& metric : metrics()) json[std::string(metric.name)] = number(s.mean(metric.name));
  json["max_m"] = number(s.max_m);
  json["max_mean_m"] = number(s.mean("max_m"));
  json["hold_max_m"] = number(s.hold_max_m);
  json["junction_accuracy"] = number(s.junction_accuracy);
  json["error_bin_m"] = kErrorBin_m;
  json["error_distribution"] = s.distribution;
  json["perception_ms"] = s.perception_ms;
  json["control_ms"] = s.control_ms;
  return json;
}

ordered_json json_of(const Pair& p) {
  ordered_json json = {{"a", p.a->label()},
                       {"b", p.b->label()},
                       {"metric", p.metric},
                       {"difference", number(p.difference.mean)},
                       {"ci95", interval(p.difference.ci95)},
                       {"pairs", p.difference.pairs}};
  json.update(identity_json(*p.a));
  json.erase("variant");
  return json;
}

ordered_json json_of(const Entry& e, const ComparedFlight& f) {
  ordered_json json = {{"controller", e.controller},   {"tuned", e.tuned},
                       {"variant", e.variant.label},   {"layout", e.layout},
                       {"instruction", f.instruction}, {"seed", f.seed},
                       {"speed_m_s", e.speed_m_s},     {"outcome", f.summary.outcome}};
  for (const Metric& metric : metrics()) json[std::string(metric.name)] = number(metric.of(f.summary));
  json["trajectory_sha256"] = f.summary.trajectory_sha256;
  json["command"] = f.command;
  return json;
}

ordered_json published_json(const ComparisonResult& result) {
  ordered_json json = ordered_json::array();
  if (result.preset.empty()) return json;
  std::string last;
  for (const Block& block : result.options.blocks) {
    if (block.title == last) continue;
    last = block.title;
    for (const PublishedRow& row : published_beside(block.title)) json.push_back(to_json(row));
  }
  return json;
}

/// Plain numbers; nothing where not applicable.
std::string plain(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "";
}

/// "arrived:9 lost_line:1".
std::string outcomes_text(const std::map<std::string, long>& outcomes) {
  std::string text;
  for (const auto& [outcome, count] : outcomes)
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", outcome, count);
  return text;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string doubled;
  for (const char c : text) doubled.append(c == '"' ? 2 : 1, c);
  return fmt::format("\"{}\"", doubled);
}

std::string identity_csv(const Entry& e) {
  return fmt::format("{},{},{},{},{},{},{}", e.controller, e.tuned, quoted(e.variant.label), quoted(e.layout),
                     quoted(fmt::format("{}", fmt::join(e.instructions, " "))), e.speed_m_s, e.own_speed);
}
constexpr std::string_view kIdentityHeader =
    "controller,tuned,variant,layout,instructions,speed_m_s,own_speed";

}  // namespace

ordered_json comparison_json(const ComparisonResult& result) {
  ordered_json json = {{"settings", settings_json(result)}};
  for (const char* list : {"controllers", "pairs", "flights"}) json[list] = ordered_json::array();
  for (const Contestant& c : result.contestants) {
    json["controllers"].push_back(json_of(c));
    for (const ComparedFlight& flight : c.flights) json["flights"].push_back(json_of(c.entry, flight));
  }
  for (const Pair& pair : pairs_of(result.contestants, reference_of(result.options)))
    json["pairs"].push_back(json_of(pair));
  json["published"] = published_json(result);
  return json;
}

std::string comparison_csv(const ComparisonResult& result) {
  std::string csv =
      fmt::format("{},runs,arrived,success_rate,success_low,success_high,tracked", kIdentityHeader);
  for (const Metric& metric : metrics()) csv += fmt::format(",{}", metric.name);
  csv += ",max_mean_m,junction_accuracy,outcomes,perception_ms,control_ms\n";
  for (const Contestant& c : result.contestants) {
    const Standing s = standing_of(c);
    csv +=
        fmt::format("{},{},{},{},{},{},{}", identity_csv(c.entry), s.runs, s.arrived, plain(s.success_rate()),
                    plain(s.success_ci95.low), plain(s.success_ci95.high), s.tracked);
    for (const Metric& metric : metrics()) {
      const bool extreme = metric.name == "max_m" || metric.name == "hold_max_m";
      const double value = !extreme ? s.mean(metric.name) : metric.name == "max_m" ? s.max_m : s.hold_max_m;
      csv += "," + plain(value);
    }
    csv += fmt::format(",{},{},{},{},{}\n", plain(s.mean("max_m")), plain(s.junction_accuracy),
                       outcomes_text(s.outcomes), plain(s.perception_ms), plain(s.control_ms));
  }
  return csv;
}

std::string distribution_csv(const ComparisonResult& result) {
  std::string csv = fmt::format("{},from_m,to_m,samples\n", kIdentityHeader);
  for (const Contestant& c : result.contestants) {
    const ErrorDistribution bins = standing_of(c).distribution;
    for (std::size_t i = 0; i < bins.size(); ++i) {
      const double from_m = kErrorBin_m * static_cast<double>(i);
      const std::string to = i + 1 == bins.size() ? "" : plain(from_m + kErrorBin_m);
      csv += fmt::format("{},{},{},{}\n", identity_csv(c.entry), plain(from_m), to, bins[i]);
    }
  }
  return csv;
}

}  // namespace lineservo::apps
