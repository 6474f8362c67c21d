
#include <stdint.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffinite-math-only, a part of -ffast-math, hides values that are not finite: add -fno-finite-math-only behind it"
#endif

/*
 * Sums keep their order under -fassociative-math and -funsafe-math-optimizations too.
 * A product is rounded before it is added, unless ROBOT_DYNAMICS_FMA fuses both: where Rust does it. With AVX, gcc collects
 * no operations of one state into short vectors, which costs more than it saves. Without it, it makes the lanes of angles so.
 */
#if defined(__clang__)
#if defined(__x86_64__) || defined(__i386__)
#pragma float_control(precise, on)
#endif
#pragma STDC FP_CONTRACT OFF
#pragma clang fp reassociate(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-unsafe-math-optimizations", "no-associative-math")
#ifdef __AVX__
#pragma GCC optimize("no-tree-slp-vectorize")
#endif
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

/* Constants have the size of a WORD: if this line is refused, compile without -fsingle-precision-constant. */
typedef char robot_dynamics_compile_without_fsingle_precision_constant[sizeof(ONE) == sizeof(WORD) ? 1 : -1];
