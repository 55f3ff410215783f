#pragma once

#include <Eigen/Core>
#include <memory>

#include "servo/task/command.h"

class vpBasicFeature;

namespace lineservo::servo {

/// Gain of a task as ViSP's vpAdaptiveGain has it: λ(x) from `at_zero` to `at_infinity`, x = ‖J⁺e‖ in m/s and
/// rad/s.
struct AdaptiveGain {
  double at_zero = 1.0;
  double at_infinity = 1.0;
  double slope_at_zero = 1.0;
};

/// Where the interaction matrix is taken (Chaumette and Hutchinson, Visual servo control I, §III): at the
/// features as they are, as they should be, or the mean of the two.
enum class InteractionMatrix { current, desired, mean };

/// What a task says: the command and whether it can be trusted.
struct TaskSolution {
  VelocityCommand command;
  unsigned rank = 0;
  bool valid = false;  ///< full rank and finite
};

/// One vpServo, eye in hand, in the four degrees of freedom of a level quadrotor: q̇ = (forward, left, up, yaw
/// rate) in the heading frame. Features live in the virtual level camera. Everything vpServo needs is set
/// anew each time, and nothing of it shows.
class VisualTask {
 public:
  enum class Yaw {
    commanded,
    held,  ///< by someone else: J has no column for it, and a secondary yaw rate passes as it is
  };

  explicit VisualTask(const AdaptiveGain& gain, InteractionMatrix matrix = InteractionMatrix::current,
                      Yaw yaw = Yaw::commanded);
  ~VisualTask();
  VisualTask(const VisualTask&) = delete;
  VisualTask& operator=(const VisualTask&) = delete;

  /// Adds s with the desired s*; both must outlive the task. `dimension` is that of the selected part.
  void add(vpBasicFeature& s, vpBasicFeature& s_star, unsigned select, unsigned dimension);

  /// q̇ = −λ J⁺ e − J⁺ ê_t + (I − J⁺J) z: the primary task, the drift of
  /// the error that the vehicle does not cause (empty: none), and the secondary motion z in the null space.
  /// (Chaumette and Hutchinson, Visual servo control II, eq. 30; Espiau et al. 1992 for the redundancy.)
  TaskSolution solve(const VelocityCommand& secondary, const Eigen::VectorXd& error_rate = {});

  /// J = L cVe eJe of the last solve(), for tests.
  Eigen::MatrixXd jacobian() const;
  /// e of the last solve().
  Eigen::VectorXd error() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lineservo::servo
