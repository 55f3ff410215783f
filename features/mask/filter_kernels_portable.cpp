#include "features/mask/filter_kernels.h"

namespace lineservo::features {
namespace {
constexpr std::size_t kBlockWords = 2;
}
}  // namespace lineservo::features

#include "features/mask/filter_kernels.inc"

namespace lineservo::features {

const FilterKernels kPortableFilterKernels{count, majority, any_along, none_across, population};

}  // namespace lineservo::features
