#pragma once

namespace lineservo::features {

/// Which instructions the pixel loops use, each set including those before it. The results are identical.
/// avx512 stands for F, BW, VL and VBMI together.
enum class Processor { portable, avx2, avx512 };

/// The fastest that this machine runs.
Processor best_processor();

}  // namespace lineservo::features
