#include "features/mask/processor.h"

namespace lineservo::features {

Processor best_processor() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") ? Processor::avx2 : Processor::portable;
#else
  return Processor::portable;
#endif
}

}  // namespace lineservo::features
