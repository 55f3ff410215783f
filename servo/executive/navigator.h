#pragma once

#include <string>

#include "servo/executive/junction_matcher.h"
#include "servo/plan/plan.h"
#include "servo/plan/whereabouts.h"

namespace lineservo::servo {

/// Keeps the plan, and where on the floor the vehicle is by the codes; plans anew when they say that it is
/// elsewhere than planned.
class Navigator {
 public:
  explicit Navigator(Plan plan);

  const Plan& plan() const { return plan_; }
  std::size_t index() const { return step_; }
  /// What is expected next or being carried out.
  const PlanStep* step() const { return step_ < plan_.steps.size() ? &plan_.steps[step_] : nullptr; }

  enum class Verdict {
    as_planned,
    planned_anew,  ///< the step is now the first of another plan, and the node its own
    ignored,       ///< more likely than not there is no node, or it tells nothing: straight on
    puzzling       ///< and there is no straight on
  };
  /// A node was told after a way since the one before; `in_time` when the plan's can have come by now.
  Verdict judge(const NodeSighting& node, const Whereabouts::Way& way, bool in_time);
  /// On to the next step, straight or when its turn was made.
  void advance();

  /// How much further than overdue another code may still come.
  double lost_limit_m() const;
  /// "at a12 by the codes (98 %)".
  std::string place() const;

 private:
  bool plan_anew(const Whereabouts::Belief& belief);

  Plan plan_;
  std::size_t step_ = 0;
  Whereabouts whereabouts_;
  int plans_made_ = 1;
};

}  // namespace lineservo::servo
