#include "features/mask/processor.h"

namespace lineservo::features {

Processor best_processor() {
#if defined(__x86_64__)
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                          __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512vbmi");
  if (has_avx512) return Processor::avx512;
  return __builtin_cpu_supports("avx2") ? Processor::avx2 : Processor::portable;
#else
  return Processor::portable;
#endif
}

}  // namespace lineservo::features
