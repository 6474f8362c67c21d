#include "ur5_robot.h"

#include <stdint.h>
#include <string.h>

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

/* Constants have the size of a double: if this line is refused, compile without -fsingle-precision-constant. */
typedef char robot_dynamics_compile_without_fsingle_precision_constant[sizeof(1.0) == sizeof(double) ? 1 : -1];

#ifndef ROBOT_DYNAMICS_FMA
#if defined(__FMA__) || defined(__aarch64__)
#define ROBOT_DYNAMICS_FMA(a, b, c) __builtin_fma(a, b, c)
#else
#define ROBOT_DYNAMICS_FMA(a, b, c) ((a) * (b) + (c))
#endif
#endif

/* In front of a loop over states: no state reads what another one writes. */
#if defined(__clang__)
#define ROBOT_DYNAMICS_LANES _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define ROBOT_DYNAMICS_LANES _Pragma("GCC ivdep")
#else
#define ROBOT_DYNAMICS_LANES
#endif

#include <float.h>

#ifdef _M_FP_FAST
#error "/fp:fast breaks the sines: compile with /fp:precise, or generate with --sines libm"
#endif

/* 16 is of numbers that are narrower than float. */
#if (FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "registers wider than the numbers (x87) break the sines: add -msse2 -mfpmath=sse (/arch:SSE2), or generate with --sines libm"
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

/** The high half of a product. */
ROBOT_DYNAMICS_DEVICE static uint64_t robot_dynamics_high(uint64_t a, uint64_t b)
{
    const uint64_t low = 0xffffffffu;
    const uint64_t first = (a >> 32) * (b & low) + ((a & low) * (b & low) >> 32);
    const uint64_t second = (a & low) * (b >> 32) + (first & low);
    return (a >> 32) * (b >> 32) + (first >> 32) + (second >> 32);
}

/**
 * x = n pi/2 + rest - excess for a finite x of at least 2^16 (Payne and Hanek 1983): `n` ends in the last two bits of n.
 */
ROBOT_DYNAMICS_DEVICE static void robot_dynamics_reduce_large(double x, double *n, double *rest, double *excess)
{
    /* The bits of 2/pi behind 64 zeros, the binary point behind these. */
    const uint64_t two_over_pi[20] = {
        0u,
        0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u, 0xfe5163abdebbc561u,
        0xb7246e3a424dd2e0u, 0x06492eea09d1921cu, 0xfe1deb1cb129a73eu, 0xe88235f52ebb4484u,
        0xe99c7026b45f7e41u, 0x3991d639835339f4u, 0x9c845f8bbdf9283bu, 0x1ff897ffde05980fu,
        0xef2f118b5a0a6d1fu, 0x6d367ecf27cb09b7u, 0x4f463f669e5fea2du, 0x7527bac7ebe5f17bu,
        0x3d0739f78a5292eau, 0x6bfb5fb11f8d5d08u, 0x56033046fc7b6babu
    };
    uint64_t bits, m, start, window[3], middle, high, quarters, turns;
    int64_t product;
    int is_negative, zeros = 0;
    double unit, size;
    memcpy(&bits, &x, sizeof bits);
    m = (bits & 0xfffffffffffffu) | 0x10000000000000u;
    start = (bits >> 52) - 1013u;
    for (turns = 0; turns < 3u; ++turns) {
        const uint64_t *at = two_over_pi + start / 64u + turns;
        window[turns] = at[0] << start % 64u | at[1] >> 1 >> (63u - start % 64u);
    }
    /* Two bits of whole quarter turns, and 126 behind the point. */
    middle = m * window[1] + robot_dynamics_high(m, window[2]);
    high = robot_dynamics_high(m, window[1]) + (middle < m * window[1]);
    quarters = m * window[0] + high;
    turns = (quarters + ((uint64_t)1 << 61)) >> 62;
    quarters -= turns << 62;
    is_negative = quarters >> 63 != 0u;
    if (is_negative) {
        middle = 0u - middle;
        quarters = 0u - quarters - (middle != 0u);
    }
    for (; !(quarters >> 63); ++zeros) {
        quarters = quarters << 1 | middle >> 63;
        middle <<= 1;
    }
    /* 63 bits of the rest in units of 2^-(60 + zeros): pi/2 is in units of 2^-62. */
    product = (int64_t)robot_dynamics_high(quarters, 0x6487ed5110b4611au);
    bits = (uint64_t)(1023 - 60 - zeros) << 52;
    memcpy(&unit, &bits, sizeof unit);
    if (is_negative) unit = -unit;
    size = (double)product;
    memcpy(n, &turns, sizeof turns);
    *rest = size * unit;
    *excess = (double)((int64_t)size - product) * unit;
}

/** x = n pi/2 + rest - excess (Cody and Waite 1980). Products with the parts of pi/2 are exact; `n` ends in the bits of n. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_reduce_1(const double *x, double *n, double *rest, double *excess)
{
    const double shifted = *x * 0.6366197723675814 + 6755399441055744.0;
    const double turns = shifted - 6755399441055744.0;
    const double first = *x - turns * 1.5707963267923333;
    const double second = turns * 2.5633441515839558e-12;
    *n = shifted;
    *rest = first - second;
    *excess = turns * 1.0562999066987428e-23 + ((*rest - first) + second);
}

/** sin (x - d) by a minimax polynomial: |x| is at most a little above pi/4, and d below its last place. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sine_1(const double *x, const double *d, double *sine)
{
    const double z = *x * *x, cube = *x * z, zz = z * z, fifth = z * cube;
    const double w = 1.0 - 0.5 * z;
    const double upper = (-2.755731369191555e-06 + z * 2.505075811569819e-08) + zz * -1.5896795713489563e-10;
    const double lower = fifth * (-0.008333333333322413 + z * 0.00019841269829807778) + *d * w;
    *sine = *x - (cube * 0.16666666666666632 + (lower + (zz * fifth) * upper));
}

/** cos (x - d): the rounding of w = 1 - x^2/2 is made good. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_cosine_1(const double *x, const double *d, double *cosine)
{
    const double z = *x * *x, zz = z * z;
    const double half_z = 0.5 * z, w = 1.0 - half_z;
    const double lost = (1.0 - w) - half_z;
    const double upper = (2.480158728948234e-05 + z * -2.7557314352372173e-07)
        + zz * (2.0875723278132235e-09 + z * -1.1359648042271599e-11);
    const double lower = zz * (0.0416666666666666 + z * -0.0013888888888874125) + *x * *d;
    *cosine = w + ((lost + lower) + (zz * zz) * upper);
}

/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_1(const double *n, const double *s, const double *c, double *sine, double *cosine)
{
    uint64_t turns, a, b, other;
    memcpy(&turns, n, sizeof turns);
    memcpy(&a, s, sizeof a);
    memcpy(&b, c, sizeof b);
    other = (a ^ b) & -(turns & 1u);
    a ^= other ^ turns >> 1 << 63;
    b ^= other ^ (turns ^ turns >> 1) << 63;
    memcpy(sine, &a, sizeof a);
    memcpy(cosine, &b, sizeof b);
}

/** Sines and cosines of angles of magnitude up to 1e5, without a branch. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_of_1(const double *x, double *sine, double *cosine)
{
    double n, rest, excess, s, c;
    robot_dynamics_reduce_1(x, &n, &rest, &excess);
    robot_dynamics_sine_1(&rest, &excess, &s);
    robot_dynamics_cosine_1(&rest, &excess, &c);
    robot_dynamics_turn_1(&n, &s, &c, sine, cosine);
}

/** Whether an angle needs no reduction in integers; not so for what is no number. */
#define ROBOT_DYNAMICS_IS_USUAL(x) ((x) >= -1e5 && (x) <= 1e5)

/** Sine and cosine of any angle: less than a unit in the last place off, NaN of what is not finite. */
ROBOT_DYNAMICS_APART void robot_dynamics_sin_cos(double x, double *sine, double *cosine)
{
    double n, rest, excess, s, c;
    const double size = x < 0.0 ? -x : x;
    if (ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos_of_1(&x, sine, cosine);
        return;
    }
    if (!(size <= 1.7976931348623157e308)) {
        *sine = *cosine = x - x;
        return;
    }
    robot_dynamics_reduce_large(size, &n, &rest, &excess);
    robot_dynamics_sine_1(&rest, &excess, &s);
    robot_dynamics_cosine_1(&rest, &excess, &c);
    robot_dynamics_turn_1(&n, &s, &c, sine, cosine);
    if (x < 0.0) *sine = -*sine;
}

/** Sines and cosines of a column of angles. */
ROBOT_DYNAMICS_APART void robot_dynamics_sin_cos_column(const double *x, double *sines, double *cosines, size_t n)
{
    uint64_t unusual = 0u;
    size_t k;
    ROBOT_DYNAMICS_LANES
    for (k = 0; k < n; ++k) {
        unusual |= !((x[k] >= -1e5) & (x[k] <= 1e5));
        robot_dynamics_sin_cos_of_1(x + k, sines + k, cosines + k);
    }
    for (k = 0; unusual && k < n; ++k) robot_dynamics_sin_cos(x[k], sines + k, cosines + k);
}

#ifdef ROBOT_DYNAMICS_VECTORS
typedef double robot_dynamics_4 __attribute__((vector_size(32)));
typedef uint64_t robot_dynamics_bits_4 __attribute__((vector_size(32)));

/** x = n pi/2 + rest - excess (Cody and Waite 1980). Products with the parts of pi/2 are exact; `n` ends in the bits of n. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_reduce_4(const robot_dynamics_4 *x, robot_dynamics_4 *n, robot_dynamics_4 *rest, robot_dynamics_4 *excess)
{
    const robot_dynamics_4 shifted = *x * 0.6366197723675814 + 6755399441055744.0;
    const robot_dynamics_4 turns = shifted - 6755399441055744.0;
    const robot_dynamics_4 first = *x - turns * 1.5707963267923333;
    const robot_dynamics_4 second = turns * 2.5633441515839558e-12;
    *n = shifted;
    *rest = first - second;
    *excess = turns * 1.0562999066987428e-23 + ((*rest - first) + second);
}

/** sin (x - d) by a minimax polynomial: |x| is at most a little above pi/4, and d below its last place. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sine_4(const robot_dynamics_4 *x, const robot_dynamics_4 *d, robot_dynamics_4 *sine)
{
    const robot_dynamics_4 z = *x * *x, cube = *x * z, zz = z * z, fifth = z * cube;
    const robot_dynamics_4 w = 1.0 - 0.5 * z;
    const robot_dynamics_4 upper = (-2.755731369191555e-06 + z * 2.505075811569819e-08) + zz * -1.5896795713489563e-10;
    const robot_dynamics_4 lower = fifth * (-0.008333333333322413 + z * 0.00019841269829807778) + *d * w;
    *sine = *x - (cube * 0.16666666666666632 + (lower + (zz * fifth) * upper));
}

/** cos (x - d): the rounding of w = 1 - x^2/2 is made good. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_cosine_4(const robot_dynamics_4 *x, const robot_dynamics_4 *d, robot_dynamics_4 *cosine)
{
    const robot_dynamics_4 z = *x * *x, zz = z * z;
    const robot_dynamics_4 half_z = 0.5 * z, w = 1.0 - half_z;
    const robot_dynamics_4 lost = (1.0 - w) - half_z;
    const robot_dynamics_4 upper = (2.480158728948234e-05 + z * -2.7557314352372173e-07)
        + zz * (2.0875723278132235e-09 + z * -1.1359648042271599e-11);
    const robot_dynamics_4 lower = zz * (0.0416666666666666 + z * -0.0013888888888874125) + *x * *d;
    *cosine = w + ((lost + lower) + (zz * zz) * upper);
}

/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_4(const robot_dynamics_4 *n, const robot_dynamics_4 *s, const robot_dynamics_4 *c, robot_dynamics_4 *sine, robot_dynamics_4 *cosine)
{
    robot_dynamics_bits_4 turns, a, b, other;
    memcpy(&turns, n, sizeof turns);
    memcpy(&a, s, sizeof a);
    memcpy(&b, c, sizeof b);
    other = (a ^ b) & -(turns & 1u);
    a ^= other ^ turns >> 1 << 63;
    b ^= other ^ (turns ^ turns >> 1) << 63;
    memcpy(sine, &a, sizeof a);
    memcpy(cosine, &b, sizeof b);
}

/** Sines and cosines of angles of magnitude up to 1e5, without a branch. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_of_4(const robot_dynamics_4 *x, robot_dynamics_4 *sine, robot_dynamics_4 *cosine)
{
    robot_dynamics_4 n, rest, excess, s, c;
    robot_dynamics_reduce_4(x, &n, &rest, &excess);
    robot_dynamics_sine_4(&rest, &excess, &s);
    robot_dynamics_cosine_4(&rest, &excess, &c);
    robot_dynamics_turn_4(&n, &s, &c, sine, cosine);
}
#else
typedef double robot_dynamics_4[4];
#endif

/** Sines and cosines of 3 angles. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_3(double a, double b, double c, robot_dynamics_4 *sines, robot_dynamics_4 *cosines)
{
    double sine, cosine;
#ifdef ROBOT_DYNAMICS_VECTORS
    if (ROBOT_DYNAMICS_FMA(a, a, ROBOT_DYNAMICS_FMA(b, b, c * c)) < 1e10) {
        const robot_dynamics_4 x = {a, b, c, 0.0};
        robot_dynamics_sin_cos_of_4(&x, sines, cosines);
        return;
    }
#endif
    robot_dynamics_sin_cos(a, &sine, &cosine);
    (*sines)[0] = sine, (*cosines)[0] = cosine;
    robot_dynamics_sin_cos(b, &sine, &cosine);
    (*sines)[1] = sine, (*cosines)[1] = cosine;
    robot_dynamics_sin_cos(c, &sine, &cosine);
    (*sines)[2] = sine, (*cosines)[2] = cosine;
}

ROBOT_DYNAMICS_DEVICE void ur5_robot_gravity_vector(const double q[6], double gravity_vector[6])
{
    robot_dynamics_4 sines_1, cosines_1;
    robot_dynamics_sin_cos_3(q[1], q[2], q[3], &sines_1, &cosines_1);
    const double s_2 = sines_1[0];
    const double c_2 = cosines_1[0];
    const double s_3 = sines_1[1];
    const double c_3 = cosines_1[1];
    const double s_4 = sines_1[2];
    const double c_4 = cosines_1[2];
    const double t_1 = ROBOT_DYNAMICS_FMA(c_2, s_3, s_2 * c_3);
    const double t_2 = ROBOT_DYNAMICS_FMA(-c_2, c_3, s_2 * s_3);
    const double t_3 = ROBOT_DYNAMICS_FMA(-s_4, t_2, c_4 * t_1);
    const double t_4 = 0.17446825035 * t_3;
    const double t_5 = ROBOT_DYNAMICS_FMA(15.68382848775, t_2, t_4);
    const double t_6 = ROBOT_DYNAMICS_FMA(-43.486969725, c_2, t_5);
    gravity_vector[0] = 0.0;
    gravity_vector[1] = t_6;
    gravity_vector[2] = t_5;
    gravity_vector[3] = t_4;
    gravity_vector[4] = 0.0;
    gravity_vector[5] = 0.0;
}

ROBOT_DYNAMICS_DEVICE void ur5_robot_gravity_vector_batch(const double *const *q, double *const *gravity_vector, size_t n)
{
    double angles[64], sines[3][64], cosines[3][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        for (k = 0; k < count; ++k) angles[k] = q[1][start + k];
        robot_dynamics_sin_cos_column(angles, sines[0], cosines[0], count);
        for (k = 0; k < count; ++k) angles[k] = q[2][start + k];
        robot_dynamics_sin_cos_column(angles, sines[1], cosines[1], count);
        for (k = 0; k < count; ++k) angles[k] = q[3][start + k];
        robot_dynamics_sin_cos_column(angles, sines[2], cosines[2], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_2 = sines[0][k];
            const double c_2 = cosines[0][k];
            const double s_3 = sines[1][k];
            const double c_3 = cosines[1][k];
            const double s_4 = sines[2][k];
            const double c_4 = cosines[2][k];
            const double t_1 = ROBOT_DYNAMICS_FMA(c_2, s_3, s_2 * c_3);
            const double t_2 = ROBOT_DYNAMICS_FMA(-c_2, c_3, s_2 * s_3);
            const double t_3 = ROBOT_DYNAMICS_FMA(-s_4, t_2, c_4 * t_1);
            const double t_4 = 0.17446825035 * t_3;
            const double t_5 = ROBOT_DYNAMICS_FMA(15.68382848775, t_2, t_4);
            const double t_6 = ROBOT_DYNAMICS_FMA(-43.486969725, c_2, t_5);
            gravity_vector[0][start + k] = 0.0;
            gravity_vector[1][start + k] = t_6;
            gravity_vector[2][start + k] = t_5;
            gravity_vector[3][start + k] = t_4;
            gravity_vector[4][start + k] = 0.0;
            gravity_vector[5][start + k] = 0.0;
        }
    }
}
