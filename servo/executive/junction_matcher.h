#pragma once

#include <optional>

#include "features/frame_features.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

/// A node recognised on the way: its code with all arms in view, whether the line goes on ahead, or how it
/// bends.
struct NodeSighting {
  features::JunctionCode code = features::JunctionCode::unrecognised;
  bool line_ends = false;
  Bend bend = Bend::none;

  friend bool operator==(const NodeSighting&, const NodeSighting&) = default;
};

/// Turns the smoothed codes of successive frames into nodes, each told once: decisions hang on transitions,
/// not on single detections (topology §2.3). What is in view at the start of a leg belongs to the node left
/// behind.
class JunctionMatcher {
 public:
  /// A node is told when it reads the same in `confirm_frames` frames in a row; one that is not expected
  /// needs `doubt_frames` more.
  explicit JunctionMatcher(int confirm_frames, int doubt_frames = 0)
      : confirm_frames_(confirm_frames), doubt_frames_(doubt_frames) {}

  void restart();
  /// `away`: the vehicle has come so far since the last node, or since the start of the leg, that it can be
  /// out of view.
  std::optional<NodeSighting> update(const features::CodeReading& reading, bool away, Bend bend = Bend::none,
                                     const NodeSignature* expected = nullptr);
  /// The node told last, or the one that the leg started from, is still in view.
  bool leaving() const { return leaving_; }

 private:
  int confirm_frames_, doubt_frames_;
  bool leaving_ = true;
  std::optional<NodeSighting> candidate_;
  int candidate_frames_ = 0;
};

/// The node that a reading shows with all its arms, or none: a red disc, ┼, ├ and ┤ by their codes; a corner,
/// a ┬ and a dead end only when the line is seen to end, because before that a ┼, ├ or ┤ that comes up reads
/// the same.
/// A bend counts before all these.
std::optional<NodeSighting> complete_node(const features::CodeReading& reading, Bend bend = Bend::none);

/// The node is what a signature says.
bool matches(const NodeSighting& node, const NodeSignature& expected);

/// Plain line and nothing else.
bool is_clear(const features::CodeReading& reading);

}  // namespace lineservo::servo
