
#include <float.h>

#ifdef _M_FP_FAST
#error "/fp:fast breaks the sines: compile with /fp:precise, or generate with --sines libm"
#endif

/* 16 is of numbers that are narrower than float. */
#if (FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "registers wider than the numbers (x87) break the sines: add -msse2 -mfpmath=sse (/arch:SSE2), or generate with --sines libm"
#endif

#ifdef __GNUC__
#define ROBOT_DYNAMICS_INLINE ROBOT_DYNAMICS_DEVICE static inline __attribute__((always_inline))
#define ROBOT_DYNAMICS_APART ROBOT_DYNAMICS_DEVICE static __attribute__((noinline))
#else
#define ROBOT_DYNAMICS_INLINE ROBOT_DYNAMICS_DEVICE static inline
#define ROBOT_DYNAMICS_APART ROBOT_DYNAMICS_DEVICE static
#endif
