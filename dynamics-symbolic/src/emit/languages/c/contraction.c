
#include <stdint.h>
#include <string.h>

/*
 * A product is rounded before it is added, unless ROBOT_DYNAMICS_FMA fuses both: where Rust does it. With AVX, gcc collects
 * no operations of one state into short vectors, which costs more than it saves. Without it, it makes the lanes of angles so.
 */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#ifdef __AVX__
#pragma GCC optimize("no-tree-slp-vectorize")
#endif
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#ifndef ROBOT_DYNAMICS_FMA
#if defined(__FMA__) || defined(__aarch64__)
#define ROBOT_DYNAMICS_FMA(a, b, c) BUILTIN(a, b, c)
#else
#define ROBOT_DYNAMICS_FMA(a, b, c) ((a) * (b) + (c))
#endif
#endif
