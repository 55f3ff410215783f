#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace lineservo::vehicle {

/// How the floor is lit. All but the shadow lies still on the floor.
struct LightOptions {
  /// The light swings between these, as a factor on colours, 0.05 … 2: along a direction that the seed draws,
  /// by a smooth step from the one to the other over half a wavelength.
  double low = 1.0;
  double high = 1.0;
  double wavelength_m = 4.0;  ///< 0.5 … 100

  double glare = 0.0;  ///< share of full scale that a specular patch adds in its middle; 0 … 1
  double glare_radius_m = 0.25;
  double glare_every_m = 2.0;  ///< one patch in each square of this side, 1 … 100

  double shadow = 0.0;  ///< share of the light that the vehicle's shadow takes in its middle; 0 … 0.9
  double shadow_radius_m = 0.35;
  double shadow_offset = 0.3;  ///< of its middle from the vehicle's foot, in heights

  bool is_plain() const { return low == 1.0 && high == 1.0 && glare == 0.0 && shadow == 0.0; }
  /// Throws std::invalid_argument that names what is out of bounds.
  void validate() const;
};

/// What becomes of a colour c (0 … 255): factor · c + 255 · glare.
struct Lighting {
  double factor = 1.0;
  double glare = 0.0;
};

/// The light on the floor. With n the drawn direction, φ a drawn phase and S(t) = t² (3 − 2t),
///   factor = low + (high − low) S(|2 frac(n·p/λ + φ) − 1|);
/// a patch of glare or shadow of radius r at p₀ has the profile (1 − |p − p₀|²/r²)² within it.
class FloorLight {
 public:
  FloorLight(const LightOptions& options, std::uint64_t seed);

  bool is_plain() const { return options_.is_plain(); }
  /// To be called before at(): where the vehicle is, and how far around it the floor is looked at.
  void look_near(const Eigen::Vector3d& p_W, double radius_m);
  Lighting at(const Eigen::Vector2d& p_W) const;
  const std::vector<Eigen::Vector2d>& glares_W() const { return glares_W_; }

 private:
  LightOptions options_;
  std::uint64_t seed_;
  Eigen::Vector2d wave_per_m_;
  Eigen::Vector2d shadow_side_;
  double phase_;
  std::vector<Eigen::Vector2d> glares_W_;
  Eigen::Vector2d shadow_W_ = Eigen::Vector2d::Zero();
};

}  // namespace lineservo::vehicle
