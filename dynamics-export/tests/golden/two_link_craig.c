#include "two_link_craig.h"

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

/* Constants have the size of a double: if this line is refused, compile without -fsingle-precision-constant. */
typedef char robot_dynamics_compile_without_fsingle_precision_constant[sizeof(1.0) == sizeof(double) ? 1 : -1];

#ifndef ROBOT_DYNAMICS_FMA
#if defined(__FMA__) || defined(__aarch64__)
#define ROBOT_DYNAMICS_FMA(a, b, c) __builtin_fma(a, b, c)
#else
#define ROBOT_DYNAMICS_FMA(a, b, c) ((a) * (b) + (c))
#endif
#endif

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

/* Angles are evaluated in the lanes of vectors where the compiler and the processor have them. */
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#if defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__) || defined(__riscv_vector) || defined(__wasm_simd128__)
#define ROBOT_DYNAMICS_VECTORS
#endif
#endif

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

/** A number and its bits. C99 lets one be read as the other (6.5.2.3), and so do compilers of C++: no function is called. */
typedef union { double real; uint64_t bits; } robot_dynamics_number_1;

/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_1(const double *n, const double *s, const double *c, double *sine, double *cosine)
{
    robot_dynamics_number_1 turns, a, b;
    uint64_t other;
    turns.real = *n;
    a.real = *s;
    b.real = *c;
    other = (a.bits ^ b.bits) & -(turns.bits & 1u);
    a.bits ^= other ^ turns.bits >> 1 << 63;
    b.bits ^= other ^ (turns.bits ^ turns.bits >> 1) << 63;
    *sine = a.real;
    *cosine = b.real;
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
    static const uint64_t two_over_pi[20] = {
        0u,
        0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u, 0xfe5163abdebbc561u,
        0xb7246e3a424dd2e0u, 0x06492eea09d1921cu, 0xfe1deb1cb129a73eu, 0xe88235f52ebb4484u,
        0xe99c7026b45f7e41u, 0x3991d639835339f4u, 0x9c845f8bbdf9283bu, 0x1ff897ffde05980fu,
        0xef2f118b5a0a6d1fu, 0x6d367ecf27cb09b7u, 0x4f463f669e5fea2du, 0x7527bac7ebe5f17bu,
        0x3d0739f78a5292eau, 0x6bfb5fb11f8d5d08u, 0x56033046fc7b6babu
    };
    uint64_t m, start, window[3], middle, high, quarters, turns;
    int64_t product;
    int is_negative, zeros = 0;
    robot_dynamics_number_1 angle, unit, last;
    double size;
    angle.real = x;
    m = (angle.bits & 0xfffffffffffffu) | 0x10000000000000u;
    start = (angle.bits >> 52) - 1013u;
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
    unit.bits = (uint64_t)(1023 - 60 - zeros) << 52;
    if (is_negative) unit.real = -unit.real;
    size = (double)product;
    last.bits = turns;
    *n = last.real;
    *rest = size * unit.real;
    *excess = (double)((int64_t)size - product) * unit.real;
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

/** The sine alone, with the digits that it has beside the other: a branch between the polynomials is predicted. */
ROBOT_DYNAMICS_INLINE double robot_dynamics_sin(double x)
{
    double rest, excess, sine, cosine;
    robot_dynamics_number_1 turns, value;
    if (!ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos(x, &sine, &cosine);
        return sine;
    }
    robot_dynamics_reduce_1(&x, &turns.real, &rest, &excess);
    if ((turns.bits & 1u) == 0u) {
        robot_dynamics_sine_1(&rest, &excess, &value.real);
    } else {
        robot_dynamics_cosine_1(&rest, &excess, &value.real);
    }
    value.bits ^= (turns.bits >> 1) << 63;
    return value.real;
}

/** The cosine alone, with the digits that it has beside the other: a branch between the polynomials is predicted. */
ROBOT_DYNAMICS_INLINE double robot_dynamics_cos(double x)
{
    double rest, excess, sine, cosine;
    robot_dynamics_number_1 turns, value;
    if (!ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos(x, &sine, &cosine);
        return cosine;
    }
    robot_dynamics_reduce_1(&x, &turns.real, &rest, &excess);
    if ((turns.bits & 1u) == 1u) {
        robot_dynamics_sine_1(&rest, &excess, &value.real);
    } else {
        robot_dynamics_cosine_1(&rest, &excess, &value.real);
    }
    value.bits ^= (turns.bits ^ turns.bits >> 1) << 63;
    return value.real;
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
typedef double robot_dynamics_2 __attribute__((vector_size(16)));
typedef uint64_t robot_dynamics_bits_2 __attribute__((vector_size(16)));

/** x = n pi/2 + rest - excess (Cody and Waite 1980). Products with the parts of pi/2 are exact; `n` ends in the bits of n. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_reduce_2(const robot_dynamics_2 *x, robot_dynamics_2 *n, robot_dynamics_2 *rest, robot_dynamics_2 *excess)
{
    const robot_dynamics_2 shifted = *x * 0.6366197723675814 + 6755399441055744.0;
    const robot_dynamics_2 turns = shifted - 6755399441055744.0;
    const robot_dynamics_2 first = *x - turns * 1.5707963267923333;
    const robot_dynamics_2 second = turns * 2.5633441515839558e-12;
    *n = shifted;
    *rest = first - second;
    *excess = turns * 1.0562999066987428e-23 + ((*rest - first) + second);
}

/** sin (x - d) by a minimax polynomial: |x| is at most a little above pi/4, and d below its last place. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sine_2(const robot_dynamics_2 *x, const robot_dynamics_2 *d, robot_dynamics_2 *sine)
{
    const robot_dynamics_2 z = *x * *x, cube = *x * z, zz = z * z, fifth = z * cube;
    const robot_dynamics_2 w = 1.0 - 0.5 * z;
    const robot_dynamics_2 upper = (-2.755731369191555e-06 + z * 2.505075811569819e-08) + zz * -1.5896795713489563e-10;
    const robot_dynamics_2 lower = fifth * (-0.008333333333322413 + z * 0.00019841269829807778) + *d * w;
    *sine = *x - (cube * 0.16666666666666632 + (lower + (zz * fifth) * upper));
}

/** cos (x - d): the rounding of w = 1 - x^2/2 is made good. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_cosine_2(const robot_dynamics_2 *x, const robot_dynamics_2 *d, robot_dynamics_2 *cosine)
{
    const robot_dynamics_2 z = *x * *x, zz = z * z;
    const robot_dynamics_2 half_z = 0.5 * z, w = 1.0 - half_z;
    const robot_dynamics_2 lost = (1.0 - w) - half_z;
    const robot_dynamics_2 upper = (2.480158728948234e-05 + z * -2.7557314352372173e-07)
        + zz * (2.0875723278132235e-09 + z * -1.1359648042271599e-11);
    const robot_dynamics_2 lower = zz * (0.0416666666666666 + z * -0.0013888888888874125) + *x * *d;
    *cosine = w + ((lost + lower) + (zz * zz) * upper);
}

/** A number and its bits. C99 lets one be read as the other (6.5.2.3), and so do compilers of C++: no function is called. */
typedef union { robot_dynamics_2 real; robot_dynamics_bits_2 bits; } robot_dynamics_number_2;

/** The sine and the cosine of what is left, turned by n quarters: (s, c) -> (c, -s). */
ROBOT_DYNAMICS_INLINE void robot_dynamics_turn_2(const robot_dynamics_2 *n, const robot_dynamics_2 *s, const robot_dynamics_2 *c, robot_dynamics_2 *sine, robot_dynamics_2 *cosine)
{
    robot_dynamics_number_2 turns, a, b;
    robot_dynamics_bits_2 other;
    turns.real = *n;
    a.real = *s;
    b.real = *c;
    other = (a.bits ^ b.bits) & -(turns.bits & 1u);
    a.bits ^= other ^ turns.bits >> 1 << 63;
    b.bits ^= other ^ (turns.bits ^ turns.bits >> 1) << 63;
    *sine = a.real;
    *cosine = b.real;
}

/** Sines and cosines of angles of magnitude up to 1e5, without a branch. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_of_2(const robot_dynamics_2 *x, robot_dynamics_2 *sine, robot_dynamics_2 *cosine)
{
    robot_dynamics_2 n, rest, excess, s, c;
    robot_dynamics_reduce_2(x, &n, &rest, &excess);
    robot_dynamics_sine_2(&rest, &excess, &s);
    robot_dynamics_cosine_2(&rest, &excess, &c);
    robot_dynamics_turn_2(&n, &s, &c, sine, cosine);
}
#else
typedef double robot_dynamics_2[2];
#endif

/** Sines and cosines of 2 angles. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_2(double a, double b, robot_dynamics_2 *sines, robot_dynamics_2 *cosines)
{
    double sine, cosine;
#ifdef ROBOT_DYNAMICS_VECTORS
    if (ROBOT_DYNAMICS_FMA(a, a, b * b) < 1e10) {
        const robot_dynamics_2 x = {a, b};
        robot_dynamics_sin_cos_of_2(&x, sines, cosines);
        return;
    }
#endif
    robot_dynamics_sin_cos(a, &sine, &cosine);
    (*sines)[0] = sine;
    (*cosines)[0] = cosine;
    robot_dynamics_sin_cos(b, &sine, &cosine);
    (*sines)[1] = sine;
    (*cosines)[1] = cosine;
}

/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivot(double pivot, double diagonal)
{
    const double rounding = diagonal * 1.7763568394002505e-15;
    return (pivot > rounding) & (pivot > -rounding);
}

ROBOT_DYNAMICS_DEVICE static double robot_dynamics_nan(void)
{
    const double zero = 0.0;
    return zero / zero;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_mass_matrix(const two_link_craig_fields *arm, const double q[2], double mass_matrix[2][2])
{
    const double c_2 = robot_dynamics_cos(q[1]);
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double t_1 = p_m1 + p_m2;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_m2 * p_l2;
    const double t_4 = p_l2 * t_3;
    const double t_5 = c_2 * t_3;
    const double t_6 = p_l1 * t_5;
    const double t_7 = t_4 + t_6;
    const double t_8 = ROBOT_DYNAMICS_FMA(p_l1, t_2, t_6);
    const double t_9 = t_7 + t_8;
    mass_matrix[0][0] = t_9;
    mass_matrix[0][1] = t_7;
    mass_matrix[1][0] = t_7;
    mass_matrix[1][1] = t_4;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_mass_matrix_batch(const two_link_craig_fields *arm, const double *const *q, double *const *mass_matrix, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[1][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double c_2 = cosines[0][k];
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double t_1 = p_m1 + p_m2;
            const double t_2 = p_l1 * t_1;
            const double t_3 = p_m2 * p_l2;
            const double t_4 = p_l2 * t_3;
            const double t_5 = c_2 * t_3;
            const double t_6 = p_l1 * t_5;
            const double t_7 = t_4 + t_6;
            const double t_8 = ROBOT_DYNAMICS_FMA(p_l1, t_2, t_6);
            const double t_9 = t_7 + t_8;
            mass_matrix[0][start + k] = t_9;
            mass_matrix[1][start + k] = t_7;
            mass_matrix[2][start + k] = t_7;
            mass_matrix[3][start + k] = t_4;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_coriolis_vector(const two_link_craig_fields *arm, const double q[2], const double qd[2], double coriolis_vector[2])
{
    const double s_2 = robot_dynamics_sin(q[1]);
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double t_1 = p_m2 * p_l2;
    const double t_2 = p_l1 * s_2;
    const double t_3 = t_1 * t_2;
    const double t_4 = qd_1 * t_3;
    const double t_5 = qd_1 * t_4;
    const double t_6 = ROBOT_DYNAMICS_FMA(qd_2, t_3, t_4);
    const double t_7 = t_4 + t_6;
    const double t_8 = qd_2 * t_7;
    coriolis_vector[0] = -t_8;
    coriolis_vector[1] = t_5;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_coriolis_vector_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, double *const *coriolis_vector, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[1][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_2 = sines[0][k];
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double qd_1 = qd[0][start + k];
            const double qd_2 = qd[1][start + k];
            const double t_1 = p_m2 * p_l2;
            const double t_2 = p_l1 * s_2;
            const double t_3 = t_1 * t_2;
            const double t_4 = qd_1 * t_3;
            const double t_5 = qd_1 * t_4;
            const double t_6 = ROBOT_DYNAMICS_FMA(qd_2, t_3, t_4);
            const double t_7 = t_4 + t_6;
            const double t_8 = qd_2 * t_7;
            coriolis_vector[0][start + k] = -t_8;
            coriolis_vector[1][start + k] = t_5;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_gravity_vector(const two_link_craig_fields *arm, const double q[2], double gravity_vector[2])
{
    robot_dynamics_2 sines_1, cosines_1;
    robot_dynamics_sin_cos_2(q[0], q[1], &sines_1, &cosines_1);
    const double s_1 = sines_1[0];
    const double c_1 = cosines_1[0];
    const double s_2 = sines_1[1];
    const double c_2 = cosines_1[1];
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double t_1 = p_m1 + p_m2;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_m2 * p_l2;
    const double t_4 = ROBOT_DYNAMICS_FMA(-s_1, s_2, c_1 * c_2);
    const double t_5 = t_3 * t_4;
    const double t_6 = p_g * t_5;
    const double t_7 = ROBOT_DYNAMICS_FMA(c_1, t_2, t_5);
    const double t_8 = p_g * t_7;
    gravity_vector[0] = t_8;
    gravity_vector[1] = t_6;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_gravity_vector_batch(const two_link_craig_fields *arm, const double *const *q, double *const *gravity_vector, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[2][64], cosines[2][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[0][start], sines[0], cosines[0], count);
        robot_dynamics_sin_cos_column(&q[1][start], sines[1], cosines[1], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_1 = sines[0][k];
            const double c_1 = cosines[0][k];
            const double s_2 = sines[1][k];
            const double c_2 = cosines[1][k];
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double p_g = own.g;
            const double t_1 = p_m1 + p_m2;
            const double t_2 = p_l1 * t_1;
            const double t_3 = p_m2 * p_l2;
            const double t_4 = ROBOT_DYNAMICS_FMA(-s_1, s_2, c_1 * c_2);
            const double t_5 = t_3 * t_4;
            const double t_6 = p_g * t_5;
            const double t_7 = ROBOT_DYNAMICS_FMA(c_1, t_2, t_5);
            const double t_8 = p_g * t_7;
            gravity_vector[0][start + k] = t_8;
            gravity_vector[1][start + k] = t_6;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_inverse_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double qdd[2], double inverse_dynamics[2])
{
    robot_dynamics_2 sines_1, cosines_1;
    robot_dynamics_sin_cos_2(q[0], q[1], &sines_1, &cosines_1);
    const double s_1 = sines_1[0];
    const double c_1 = cosines_1[0];
    const double s_2 = sines_1[1];
    const double c_2 = cosines_1[1];
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double qdd_1 = qdd[0];
    const double qdd_2 = qdd[1];
    const double t_1 = qd_1 + qd_2;
    const double t_2 = t_1 * t_1;
    const double t_3 = p_m1 + p_m2;
    const double t_4 = p_l1 * t_3;
    const double t_5 = p_m2 * p_l2;
    const double t_6 = qdd_1 + qdd_2;
    const double t_7 = p_l2 * t_5;
    const double t_8 = c_2 * t_5;
    const double t_9 = s_2 * t_5;
    const double t_10 = ROBOT_DYNAMICS_FMA(-t_9, t_2, t_8 * t_6);
    const double t_11 = ROBOT_DYNAMICS_FMA(p_g, c_1, p_l1 * qdd_1);
    const double t_12 = ROBOT_DYNAMICS_FMA(t_8, t_11, t_7 * t_6);
    const double t_13 = qd_1 * qd_1;
    const double t_14 = ROBOT_DYNAMICS_FMA(p_l1, t_10, t_4 * t_11);
    const double t_15 = ROBOT_DYNAMICS_FMA(-p_l1, t_13, p_g * s_1);
    const double t_16 = ROBOT_DYNAMICS_FMA(-t_9, t_15, t_12);
    const double t_17 = t_16 + t_14;
    inverse_dynamics[0] = t_17;
    inverse_dynamics[1] = t_16;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_inverse_dynamics_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, const double *const *qdd, double *const *inverse_dynamics, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[2][64], cosines[2][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[0][start], sines[0], cosines[0], count);
        robot_dynamics_sin_cos_column(&q[1][start], sines[1], cosines[1], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_1 = sines[0][k];
            const double c_1 = cosines[0][k];
            const double s_2 = sines[1][k];
            const double c_2 = cosines[1][k];
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double p_g = own.g;
            const double qd_1 = qd[0][start + k];
            const double qd_2 = qd[1][start + k];
            const double qdd_1 = qdd[0][start + k];
            const double qdd_2 = qdd[1][start + k];
            const double t_1 = qd_1 + qd_2;
            const double t_2 = t_1 * t_1;
            const double t_3 = p_m1 + p_m2;
            const double t_4 = p_l1 * t_3;
            const double t_5 = p_m2 * p_l2;
            const double t_6 = qdd_1 + qdd_2;
            const double t_7 = p_l2 * t_5;
            const double t_8 = c_2 * t_5;
            const double t_9 = s_2 * t_5;
            const double t_10 = ROBOT_DYNAMICS_FMA(-t_9, t_2, t_8 * t_6);
            const double t_11 = ROBOT_DYNAMICS_FMA(p_g, c_1, p_l1 * qdd_1);
            const double t_12 = ROBOT_DYNAMICS_FMA(t_8, t_11, t_7 * t_6);
            const double t_13 = qd_1 * qd_1;
            const double t_14 = ROBOT_DYNAMICS_FMA(p_l1, t_10, t_4 * t_11);
            const double t_15 = ROBOT_DYNAMICS_FMA(-p_l1, t_13, p_g * s_1);
            const double t_16 = ROBOT_DYNAMICS_FMA(-t_9, t_15, t_12);
            const double t_17 = t_16 + t_14;
            inverse_dynamics[0][start + k] = t_17;
            inverse_dynamics[1][start + k] = t_16;
        }
    }
}

ROBOT_DYNAMICS_DEVICE int two_link_craig_forward_dynamics(const two_link_craig_fields *arm, const double q[2], const double qd[2], const double tau[2], double forward_dynamics[2])
{
    robot_dynamics_2 sines_1, cosines_1;
    robot_dynamics_sin_cos_2(q[0], q[1], &sines_1, &cosines_1);
    const double s_1 = sines_1[0];
    const double c_1 = cosines_1[0];
    const double s_2 = sines_1[1];
    const double c_2 = cosines_1[1];
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double tau_1 = tau[0];
    const double tau_2 = tau[1];
    const double t_1 = qd_1 + qd_2;
    const double t_2 = t_1 * t_1;
    const double t_3 = p_m1 + p_m2;
    const double t_4 = p_l1 * t_3;
    const double t_5 = p_m2 * p_l2;
    const double t_6 = qd_1 * qd_1;
    const double t_7 = p_l2 * t_5;
    const double t_8 = 1.0 / t_7;
    const double t_9 = s_2 * t_5;
    const double t_10 = c_2 * t_5;
    const double t_11 = t_9 * t_2;
    const double t_12 = ROBOT_DYNAMICS_FMA(-p_l1, t_6, p_g * s_1);
    const double t_13 = p_g * c_1;
    const double t_14 = ROBOT_DYNAMICS_FMA(-t_9, t_12, t_10 * t_13);
    const double t_15 = p_l1 * t_10;
    const double t_16 = ROBOT_DYNAMICS_FMA(-t_4, t_13, tau_1);
    const double t_17 = t_7 + t_15;
    const double t_18 = ROBOT_DYNAMICS_FMA(p_l1, t_4, t_15);
    const double t_19 = ROBOT_DYNAMICS_FMA(p_l1, t_11, t_16);
    const double t_20 = t_17 + t_18;
    const double t_21 = t_17 * t_8;
    const double t_22 = ROBOT_DYNAMICS_FMA(-t_17, t_21, t_20);
    const double t_23 = t_19 - t_14;
    const double t_24 = t_14 - tau_2;
    const double t_25 = ROBOT_DYNAMICS_FMA(t_24, t_21, t_23);
    const double t_26 = 1.0 / t_22;
    const double t_27 = t_25 * t_26;
    const double t_28 = ROBOT_DYNAMICS_FMA(t_21, t_27, t_24 * t_8);
    if (!robot_dynamics_is_pivot(t_7, t_7)) return 2;
    if (!robot_dynamics_is_pivot(t_22, t_20)) return 1;
    forward_dynamics[0] = t_27;
    forward_dynamics[1] = -t_28;
    return 0;
}

ROBOT_DYNAMICS_DEVICE size_t two_link_craig_forward_dynamics_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, const double *const *tau, double *const *forward_dynamics, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[2][64], cosines[2][64];
    double regular[64];
    uint64_t refused = 0u;
    size_t first = 0;
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[0][start], sines[0], cosines[0], count);
        robot_dynamics_sin_cos_column(&q[1][start], sines[1], cosines[1], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_1 = sines[0][k];
            const double c_1 = cosines[0][k];
            const double s_2 = sines[1][k];
            const double c_2 = cosines[1][k];
            int is_regular = 1;
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double p_g = own.g;
            const double qd_1 = qd[0][start + k];
            const double qd_2 = qd[1][start + k];
            const double tau_1 = tau[0][start + k];
            const double tau_2 = tau[1][start + k];
            const double t_1 = qd_1 + qd_2;
            const double t_2 = t_1 * t_1;
            const double t_3 = p_m1 + p_m2;
            const double t_4 = p_l1 * t_3;
            const double t_5 = p_m2 * p_l2;
            const double t_6 = qd_1 * qd_1;
            const double t_7 = p_l2 * t_5;
            const double t_8 = 1.0 / t_7;
            const double t_9 = s_2 * t_5;
            const double t_10 = c_2 * t_5;
            const double t_11 = t_9 * t_2;
            const double t_12 = ROBOT_DYNAMICS_FMA(-p_l1, t_6, p_g * s_1);
            const double t_13 = p_g * c_1;
            const double t_14 = ROBOT_DYNAMICS_FMA(-t_9, t_12, t_10 * t_13);
            const double t_15 = p_l1 * t_10;
            const double t_16 = ROBOT_DYNAMICS_FMA(-t_4, t_13, tau_1);
            const double t_17 = t_7 + t_15;
            const double t_18 = ROBOT_DYNAMICS_FMA(p_l1, t_4, t_15);
            const double t_19 = ROBOT_DYNAMICS_FMA(p_l1, t_11, t_16);
            const double t_20 = t_17 + t_18;
            const double t_21 = t_17 * t_8;
            const double t_22 = ROBOT_DYNAMICS_FMA(-t_17, t_21, t_20);
            const double t_23 = t_19 - t_14;
            const double t_24 = t_14 - tau_2;
            const double t_25 = ROBOT_DYNAMICS_FMA(t_24, t_21, t_23);
            const double t_26 = 1.0 / t_22;
            const double t_27 = t_25 * t_26;
            const double t_28 = ROBOT_DYNAMICS_FMA(t_21, t_27, t_24 * t_8);
            is_regular &= robot_dynamics_is_pivot(t_7, t_7);
            is_regular &= robot_dynamics_is_pivot(t_22, t_20);
            regular[k] = is_regular ? 1.0 : robot_dynamics_nan();
            refused |= !is_regular;
            forward_dynamics[0][start + k] = t_27 * regular[k];
            forward_dynamics[1][start + k] = -t_28 * regular[k];
        }
        for (k = 0; first == 0 && refused && k < count; ++k) {
            if (!(regular[k] > 0)) first = start + k + 1;
        }
    }
    return first;
}

ROBOT_DYNAMICS_DEVICE double two_link_craig_kinetic_energy(const two_link_craig_fields *arm, const double q[2], const double qd[2])
{
    const double c_2 = robot_dynamics_cos(q[1]);
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double qd_1 = qd[0];
    const double qd_2 = qd[1];
    const double t_1 = p_l1 * qd_1;
    const double t_2 = p_m1 + p_m2;
    const double t_3 = t_2 * t_1;
    const double t_4 = p_m2 * p_l2;
    const double t_5 = qd_1 + qd_2;
    const double t_6 = p_l2 * t_4;
    const double t_7 = t_6 * t_5;
    const double t_8 = ROBOT_DYNAMICS_FMA(t_5, t_7, t_1 * t_3);
    const double t_9 = c_2 * t_1;
    const double t_10 = t_9 * t_5;
    const double t_11 = ROBOT_DYNAMICS_FMA(t_4, t_10, 0.5 * t_8);
    return t_11;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_kinetic_energy_batch(const two_link_craig_fields *arm, const double *const *q, const double *const *qd, double *kinetic_energy, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[1][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double c_2 = cosines[0][k];
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double qd_1 = qd[0][start + k];
            const double qd_2 = qd[1][start + k];
            const double t_1 = p_l1 * qd_1;
            const double t_2 = p_m1 + p_m2;
            const double t_3 = t_2 * t_1;
            const double t_4 = p_m2 * p_l2;
            const double t_5 = qd_1 + qd_2;
            const double t_6 = p_l2 * t_4;
            const double t_7 = t_6 * t_5;
            const double t_8 = ROBOT_DYNAMICS_FMA(t_5, t_7, t_1 * t_3);
            const double t_9 = c_2 * t_1;
            const double t_10 = t_9 * t_5;
            const double t_11 = ROBOT_DYNAMICS_FMA(t_4, t_10, 0.5 * t_8);
            kinetic_energy[start + k] = t_11;
        }
    }
}

ROBOT_DYNAMICS_DEVICE double two_link_craig_potential_energy(const two_link_craig_fields *arm, const double q[2])
{
    robot_dynamics_2 sines_1, cosines_1;
    robot_dynamics_sin_cos_2(q[0], q[1], &sines_1, &cosines_1);
    const double s_1 = sines_1[0];
    const double c_1 = cosines_1[0];
    const double s_2 = sines_1[1];
    const double c_2 = cosines_1[1];
    const double p_m1 = arm->m1;
    const double p_m2 = arm->m2;
    const double p_l1 = arm->l1;
    const double p_l2 = arm->l2;
    const double p_g = arm->g;
    const double t_1 = p_m1 + p_m2;
    const double t_2 = p_m2 * p_l2;
    const double t_3 = ROBOT_DYNAMICS_FMA(c_2, t_2, p_l1 * t_1);
    const double t_4 = s_2 * t_2;
    const double t_5 = ROBOT_DYNAMICS_FMA(s_1, t_3, c_1 * t_4);
    const double t_6 = p_g * t_5;
    return t_6;
}

ROBOT_DYNAMICS_DEVICE void two_link_craig_potential_energy_batch(const two_link_craig_fields *arm, const double *const *q, double *potential_energy, size_t n)
{
    const two_link_craig_fields own = {arm->m1, arm->m2, arm->l1, arm->l2, arm->g};
    double sines[2][64], cosines[2][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[0][start], sines[0], cosines[0], count);
        robot_dynamics_sin_cos_column(&q[1][start], sines[1], cosines[1], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_1 = sines[0][k];
            const double c_1 = cosines[0][k];
            const double s_2 = sines[1][k];
            const double c_2 = cosines[1][k];
            const double p_m1 = own.m1;
            const double p_m2 = own.m2;
            const double p_l1 = own.l1;
            const double p_l2 = own.l2;
            const double p_g = own.g;
            const double t_1 = p_m1 + p_m2;
            const double t_2 = p_m2 * p_l2;
            const double t_3 = ROBOT_DYNAMICS_FMA(c_2, t_2, p_l1 * t_1);
            const double t_4 = s_2 * t_2;
            const double t_5 = ROBOT_DYNAMICS_FMA(s_1, t_3, c_1 * t_4);
            const double t_6 = p_g * t_5;
            potential_energy[start + k] = t_6;
        }
    }
}
