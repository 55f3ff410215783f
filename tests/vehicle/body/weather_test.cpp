#include "vehicle/body/weather.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lineservo::vehicle {
namespace {

using namespace std::chrono_literals;

const Eigen::Vector3d kHere(1.0, 2.0, 0.5);

WeatherParameters mean_wind() {
  WeatherParameters weather;
  weather.mean_m_s = 1.5;
  weather.direction_rad = 0.7;
  return weather;
}

TEST(Weather, WithoutTurbulenceAndGustIsTheConstantWindToTheLastBit) {
  Weather weather(mean_wind(), 1);
  ConstantWind wind(1.5, 0.7);
  for (const Time t : {Time(0ms), Time(1ms), Time(25s)})
    EXPECT_EQ(weather.velocity_W(t, kHere), wind.velocity_W(t, kHere));
}

// Half of the height at a quarter, all of it in the middle, nothing before and after; along the mean wind.
TEST(Weather, AGustIsOneCosine) {
  WeatherParameters parameters = mean_wind();
  parameters.direction_rad = 0.5 * std::numbers::pi;
  parameters.gust = {2.0, 10.0, 4.0};
  Weather weather(parameters, 1);
  for (const auto& [t, speed_m_s] : {std::pair{Time(9s), 1.5},
                                     {Time(10s), 1.5},
                                     {Time(11s), 2.5},
                                     {Time(12s), 3.5},
                                     {Time(13s), 2.5},
                                     {Time(14s), 1.5},
                                     {Time(20s), 1.5}})
    EXPECT_NEAR((weather.velocity_W(t, kHere) - Eigen::Vector3d(0, speed_m_s, 0)).norm(), 0.0, 1e-12);
}

TEST(Weather, TurbulenceIsTakenAlongTheWindAndAcross) {
  WeatherParameters parameters = mean_wind();
  parameters.turbulence_m_s = 0.8;
  Weather weather(parameters, 9), same(parameters, 9), other(parameters, 10);
  Turbulence turbulence(0.8, 0.5, 1.5, 1e-3, 9);
  for (int i = 0; i < 100; ++i) turbulence.step();
  const Eigen::Vector3d v_W = weather.velocity_W(100ms, kHere);
  EXPECT_EQ(v_W, same.velocity_W(100ms, kHere));
  EXPECT_NE(v_W, other.velocity_W(100ms, kHere));
  const Eigen::Vector3d along(std::cos(0.7), std::sin(0.7), 0.0), left(-std::sin(0.7), std::cos(0.7), 0.0);
  EXPECT_NEAR(v_W.dot(along), 1.5 + turbulence.value().x(), 1e-12);
  EXPECT_NEAR(v_W.dot(left), turbulence.value().y(), 1e-12);
  EXPECT_NEAR(v_W.z(), turbulence.value().z(), 1e-12);
}

TEST(Weather, RefusesWhatIsOutOfBounds) {
  WeatherParameters parameters;
  parameters.turbulence_m_s = -1.0;
  parameters.gust.duration_s = 0.0;
  EXPECT_THROW(Weather(parameters, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
