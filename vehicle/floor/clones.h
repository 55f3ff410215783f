#pragma once

/// Compiles a function for AVX-512 and AVX2 as well as for the baseline, and picks one when the program
/// starts. All give the same bits as long as the function does elementwise IEEE arithmetic: no reordered
/// sums, no fused multiply-add (-ffp-contract=off), no fast-math.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define LINESERVO_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LINESERVO_CLONES
#endif
