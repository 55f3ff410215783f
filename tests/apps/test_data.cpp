#include <gtest/gtest.h>

#include <cstdlib>

namespace lineservo::apps {
namespace {

/// The shipped files are those of the source tree, wherever the build folder is.
class ShippedData : public ::testing::Environment {
 public:
  void SetUp() override { ::setenv("LINESERVO_DATA", LINESERVO_TEST_DATA, 1); }
};

[[maybe_unused]] const ::testing::Environment* const kShippedData =
    ::testing::AddGlobalTestEnvironment(new ShippedData);

}  // namespace
}  // namespace lineservo::apps
