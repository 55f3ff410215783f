#include "servo/executive/junction_matcher.h"

namespace lineservo::servo {

using features::CodeReading;
using features::JunctionCode;

std::optional<NodeSighting> complete_node(const CodeReading& reading, Bend bend) {
  if (bend != Bend::none) return NodeSighting{JunctionCode::straight, false, bend};
  switch (reading.smoothed) {
    case JunctionCode::start:
    case JunctionCode::cross:
    case JunctionCode::tee_right:
    case JunctionCode::tee_left:
      return NodeSighting{reading.smoothed, false, Bend::none};
    case JunctionCode::tee_ahead:
    case JunctionCode::corner_right:
    case JunctionCode::corner_left:
    case JunctionCode::straight:
      if (reading.line_ends_ahead) return NodeSighting{reading.smoothed, true, Bend::none};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

bool matches(const NodeSighting& node, const NodeSignature& expected) {
  return node.code == expected.code && node.line_ends == expected.line_ends && node.bend == expected.bend;
}

bool is_clear(const CodeReading& reading) {
  return reading.smoothed == JunctionCode::straight && !reading.line_ends_ahead;
}

void JunctionMatcher::restart() {
  leaving_ = true;
  candidate_.reset();
  candidate_frames_ = 0;
}

std::optional<NodeSighting> JunctionMatcher::update(const CodeReading& reading, bool away, Bend bend,
                                                    const NodeSignature* expected) {
  if (leaving_) {
    leaving_ = !(away && is_clear(reading));
    return std::nullopt;
  }
  const std::optional<NodeSighting> seen = complete_node(reading, bend);
  candidate_frames_ = seen && seen == candidate_ ? candidate_frames_ + 1 : 1;
  candidate_ = seen;
  const bool doubted = seen && expected && !matches(*seen, *expected);
  if (!seen || candidate_frames_ < confirm_frames_ + (doubted ? doubt_frames_ : 0)) return std::nullopt;
  restart();
  return seen;
}

}  // namespace lineservo::servo
