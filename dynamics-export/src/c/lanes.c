
/* In front of a loop over states: no state reads what another one writes. Without vectors clang would warn of it. */
#if defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__) || defined(__riscv_vector) || defined(__wasm_simd128__)
#if defined(__clang__)
#define ROBOT_DYNAMICS_LANES _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define ROBOT_DYNAMICS_LANES _Pragma("GCC ivdep")
#endif
#endif
#ifndef ROBOT_DYNAMICS_LANES
#define ROBOT_DYNAMICS_LANES
#endif
