// A controller of one's own: in proportion to where the line lies and how it points. All else, from take-off
// to the turns and the docking on the node, is the executive's.
#include "apps/cli/program.h"
#include "servo/law/controllers.h"
#include "servo/law/height_rate.h"

using namespace lineservo::servo;

class ProportionalLaw : public FollowLaw {
 public:
  ProportionalLaw(double offset_per_s, double angle_per_s)
      : offset_per_s_(offset_per_s), angle_per_s_(angle_per_s) {}

  void reset() override {}  // nothing is remembered

  Command follow(const Observation& seen, const FollowGoal& goal) override {
    VelocityCommand command;
    command.forward_m_s = goal.speed_m_s;
    command.up_m_s = height_rate(seen.estimate.height_m, goal.height_m);
    if (const auto* line = line_to_follow(seen)) {
      // ρ̇ = v_left / h and θ̇ = ω on the line: both fall to zero at their rates.
      command.left_m_s = -offset_per_s_ * line->rho * seen.estimate.capture_height_m;
      command.yaw_rate_rad_s = -angle_per_s_ * line->theta_rad;
    }
    return command;
  }

 private:
  double offset_per_s_, angle_per_s_;
};

int main(int argc, char** argv) {
  Controller mine;
  mine.name = "proportional";
  mine.summary = "in proportion to the line's offset and angle";
  mine.gains = {{.name = "offset_per_s", .value = 1.0, .high = 5.0},
                {.name = "angle_per_s", .value = 1.0, .high = 5.0}};
  mine.make = [](const LawOptions& o) {
    return std::make_unique<ProportionalLaw>(o.own_gain("proportional.offset_per_s"),
                                             o.own_gain("proportional.angle_per_s"));
  };
  add_controller(mine);
  return lineservo::apps::run_program(argc, argv);
}
