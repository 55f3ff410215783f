#pragma once

namespace lineservo::features {

/// Which instructions the pixel loops use. The results are identical.
enum class Processor { portable, avx2 };

/// The fastest that this machine runs.
Processor best_processor();

}  // namespace lineservo::features
