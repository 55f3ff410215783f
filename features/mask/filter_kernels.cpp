#include "features/mask/filter_kernels.h"

namespace lineservo::features {

const FilterKernels& filter_kernels([[maybe_unused]] Processor processor) {
#if defined(__x86_64__)
  if (processor == Processor::avx512) return kAvx512FilterKernels;
  if (processor == Processor::avx2) return kAvx2FilterKernels;
#endif
  return kPortableFilterKernels;
}

}  // namespace lineservo::features
