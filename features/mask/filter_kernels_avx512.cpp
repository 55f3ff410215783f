// Compiled with AVX-512 switched on (see CMakeLists.txt); called only where the processor has it.
#include "features/mask/filter_kernels.h"

#if defined(__x86_64__)

namespace lineservo::features {
namespace {
constexpr std::size_t kBlockWords = 8;
}
}  // namespace lineservo::features

#include "features/mask/filter_kernels.inc"

namespace lineservo::features {

const FilterKernels kAvx512FilterKernels{count, majority, any_along, none_across, population};

}  // namespace lineservo::features

#endif
