
#ifdef __FAST_MATH__
#error "-ffast-math breaks the sines: compile without it, or generate with --sines libm"
#endif

/* Angles are evaluated in the lanes of vectors where the compiler and the processor have them. */
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#if defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__) || defined(__riscv_vector) || defined(__wasm_simd128__)
#define ROBOT_DYNAMICS_VECTORS
#endif
#endif

#ifdef __GNUC__
#define ROBOT_DYNAMICS_INLINE ROBOT_DYNAMICS_DEVICE static inline __attribute__((always_inline))
#define ROBOT_DYNAMICS_APART ROBOT_DYNAMICS_DEVICE static __attribute__((noinline))
#else
#define ROBOT_DYNAMICS_INLINE ROBOT_DYNAMICS_DEVICE static inline
#define ROBOT_DYNAMICS_APART ROBOT_DYNAMICS_DEVICE static
#endif
