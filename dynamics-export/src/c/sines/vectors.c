
/* Angles are evaluated in the lanes of vectors where the compiler and the processor have them. */
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#if defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__) || defined(__riscv_vector) || defined(__wasm_simd128__)
#define ROBOT_DYNAMICS_VECTORS
#endif
#endif
