#include "fingers.h"

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

/** Sine and cosine of one angle. */
ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_1(double x, double *sine, double *cosine)
{
#ifdef ROBOT_DYNAMICS_VECTORS
    if (ROBOT_DYNAMICS_IS_USUAL(x)) {
        robot_dynamics_sin_cos_of_1(&x, sine, cosine);
        return;
    }
#endif
    robot_dynamics_sin_cos(x, sine, cosine);
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

ROBOT_DYNAMICS_DEVICE void fingers_forward_kinematics_right_tip(const fingers_fields *arm, const double q[2], double forward_kinematics[4][4])
{
    double s_2, c_2; robot_dynamics_sin_cos_1(q[1], &s_2, &c_2);
    const double p_width = arm->width;
    const double p_length = arm->length;
    const double t_1 = p_length * s_2;
    const double t_2 = ROBOT_DYNAMICS_FMA(p_length, c_2, p_width);
    forward_kinematics[0][0] = c_2;
    forward_kinematics[0][1] = -s_2;
    forward_kinematics[0][2] = 0.0;
    forward_kinematics[0][3] = t_2;
    forward_kinematics[1][0] = s_2;
    forward_kinematics[1][1] = c_2;
    forward_kinematics[1][2] = 0.0;
    forward_kinematics[1][3] = t_1;
    forward_kinematics[2][0] = 0.0;
    forward_kinematics[2][1] = 0.0;
    forward_kinematics[2][2] = 1.0;
    forward_kinematics[2][3] = 0.0;
    forward_kinematics[3][0] = 0.0;
    forward_kinematics[3][1] = 0.0;
    forward_kinematics[3][2] = 0.0;
    forward_kinematics[3][3] = 1.0;
}

ROBOT_DYNAMICS_DEVICE void fingers_forward_kinematics_right_tip_batch(const fingers_fields *arm, const double *const *q, double *const *forward_kinematics, size_t n)
{
    const fingers_fields own = {arm->width, arm->length};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[1][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_2 = sines[0][k];
            const double c_2 = cosines[0][k];
            const double p_width = own.width;
            const double p_length = own.length;
            const double t_1 = p_length * s_2;
            const double t_2 = ROBOT_DYNAMICS_FMA(p_length, c_2, p_width);
            forward_kinematics[0][start + k] = c_2;
            forward_kinematics[1][start + k] = -s_2;
            forward_kinematics[2][start + k] = 0.0;
            forward_kinematics[3][start + k] = t_2;
            forward_kinematics[4][start + k] = s_2;
            forward_kinematics[5][start + k] = c_2;
            forward_kinematics[6][start + k] = 0.0;
            forward_kinematics[7][start + k] = t_1;
            forward_kinematics[8][start + k] = 0.0;
            forward_kinematics[9][start + k] = 0.0;
            forward_kinematics[10][start + k] = 1.0;
            forward_kinematics[11][start + k] = 0.0;
            forward_kinematics[12][start + k] = 0.0;
            forward_kinematics[13][start + k] = 0.0;
            forward_kinematics[14][start + k] = 0.0;
            forward_kinematics[15][start + k] = 1.0;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void fingers_jacobian_left_tip(const fingers_fields *arm, const double q[2], double jacobian[6][2])
{
    double s_1, c_1; robot_dynamics_sin_cos_1(q[0], &s_1, &c_1);
    const double p_length = arm->length;
    const double t_1 = p_length * s_1;
    const double t_2 = p_length * c_1;
    jacobian[0][0] = -t_1;
    jacobian[0][1] = 0.0;
    jacobian[1][0] = t_2;
    jacobian[1][1] = 0.0;
    jacobian[2][0] = 0.0;
    jacobian[2][1] = 0.0;
    jacobian[3][0] = 0.0;
    jacobian[3][1] = 0.0;
    jacobian[4][0] = 0.0;
    jacobian[4][1] = 0.0;
    jacobian[5][0] = 1.0;
    jacobian[5][1] = 0.0;
}

ROBOT_DYNAMICS_DEVICE void fingers_jacobian_left_tip_batch(const fingers_fields *arm, const double *const *q, double *const *jacobian, size_t n)
{
    const fingers_fields own = {arm->width, arm->length};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[0][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_1 = sines[0][k];
            const double c_1 = cosines[0][k];
            const double p_length = own.length;
            const double t_1 = p_length * s_1;
            const double t_2 = p_length * c_1;
            jacobian[0][start + k] = -t_1;
            jacobian[1][start + k] = 0.0;
            jacobian[2][start + k] = t_2;
            jacobian[3][start + k] = 0.0;
            jacobian[4][start + k] = 0.0;
            jacobian[5][start + k] = 0.0;
            jacobian[6][start + k] = 0.0;
            jacobian[7][start + k] = 0.0;
            jacobian[8][start + k] = 0.0;
            jacobian[9][start + k] = 0.0;
            jacobian[10][start + k] = 1.0;
            jacobian[11][start + k] = 0.0;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void fingers_wrench_torques_right_tip(const fingers_fields *arm, const double q[2], const double wrench[6], double wrench_torques[2])
{
    double s_2, c_2; robot_dynamics_sin_cos_1(q[1], &s_2, &c_2);
    const double p_length = arm->length;
    const double wrench_1 = wrench[0];
    const double wrench_2 = wrench[1];
    const double wrench_6 = wrench[5];
    const double t_1 = ROBOT_DYNAMICS_FMA(-s_2, wrench_1, c_2 * wrench_2);
    const double t_2 = ROBOT_DYNAMICS_FMA(p_length, t_1, wrench_6);
    wrench_torques[0] = 0.0;
    wrench_torques[1] = t_2;
}

ROBOT_DYNAMICS_DEVICE void fingers_wrench_torques_right_tip_batch(const fingers_fields *arm, const double *const *q, const double *const *wrench, double *const *wrench_torques, size_t n)
{
    const fingers_fields own = {arm->width, arm->length};
    double sines[1][64], cosines[1][64];
    size_t start, k;
    for (start = 0; start < n; start += 64) {
        const size_t count = n - start < 64 ? n - start : 64;
        robot_dynamics_sin_cos_column(&q[1][start], sines[0], cosines[0], count);
        ROBOT_DYNAMICS_LANES
        for (k = 0; k < count; ++k) {
            const double s_2 = sines[0][k];
            const double c_2 = cosines[0][k];
            const double p_length = own.length;
            const double wrench_1 = wrench[0][start + k];
            const double wrench_2 = wrench[1][start + k];
            const double wrench_6 = wrench[5][start + k];
            const double t_1 = ROBOT_DYNAMICS_FMA(-s_2, wrench_1, c_2 * wrench_2);
            const double t_2 = ROBOT_DYNAMICS_FMA(p_length, t_1, wrench_6);
            wrench_torques[0][start + k] = 0.0;
            wrench_torques[1][start + k] = t_2;
        }
    }
}

ROBOT_DYNAMICS_DEVICE void fingers_pinch(const fingers_fields *arm, const double q[2], double mass_matrix[2][2], double jacobian_left_tip[6][2], double jacobian_right_tip[6][2])
{
    robot_dynamics_2 sines_1, cosines_1;
    robot_dynamics_sin_cos_2(q[0], q[1], &sines_1, &cosines_1);
    const double s_1 = sines_1[0];
    const double c_1 = cosines_1[0];
    const double s_2 = sines_1[1];
    const double c_2 = cosines_1[1];
    const double p_length = arm->length;
    const double t_1 = p_length * p_length;
    const double t_2 = p_length * s_1;
    const double t_3 = p_length * c_1;
    const double t_4 = p_length * s_2;
    const double t_5 = p_length * c_2;
    mass_matrix[0][0] = 0.0;
    mass_matrix[0][1] = 0.0;
    mass_matrix[1][0] = 0.0;
    mass_matrix[1][1] = t_1;
    jacobian_left_tip[0][0] = -t_2;
    jacobian_left_tip[0][1] = 0.0;
    jacobian_left_tip[1][0] = t_3;
    jacobian_left_tip[1][1] = 0.0;
    jacobian_left_tip[2][0] = 0.0;
    jacobian_left_tip[2][1] = 0.0;
    jacobian_left_tip[3][0] = 0.0;
    jacobian_left_tip[3][1] = 0.0;
    jacobian_left_tip[4][0] = 0.0;
    jacobian_left_tip[4][1] = 0.0;
    jacobian_left_tip[5][0] = 1.0;
    jacobian_left_tip[5][1] = 0.0;
    jacobian_right_tip[0][0] = 0.0;
    jacobian_right_tip[0][1] = -t_4;
    jacobian_right_tip[1][0] = 0.0;
    jacobian_right_tip[1][1] = t_5;
    jacobian_right_tip[2][0] = 0.0;
    jacobian_right_tip[2][1] = 0.0;
    jacobian_right_tip[3][0] = 0.0;
    jacobian_right_tip[3][1] = 0.0;
    jacobian_right_tip[4][0] = 0.0;
    jacobian_right_tip[4][1] = 0.0;
    jacobian_right_tip[5][0] = 0.0;
    jacobian_right_tip[5][1] = 1.0;
}

ROBOT_DYNAMICS_DEVICE void fingers_pinch_batch(const fingers_fields *arm, const double *const *q, double *const *mass_matrix, double *const *jacobian_left_tip, double *const *jacobian_right_tip, size_t n)
{
    const fingers_fields own = {arm->width, arm->length};
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
            const double p_length = own.length;
            const double t_1 = p_length * p_length;
            const double t_2 = p_length * s_1;
            const double t_3 = p_length * c_1;
            const double t_4 = p_length * s_2;
            const double t_5 = p_length * c_2;
            mass_matrix[0][start + k] = 0.0;
            mass_matrix[1][start + k] = 0.0;
            mass_matrix[2][start + k] = 0.0;
            mass_matrix[3][start + k] = t_1;
            jacobian_left_tip[0][start + k] = -t_2;
            jacobian_left_tip[1][start + k] = 0.0;
            jacobian_left_tip[2][start + k] = t_3;
            jacobian_left_tip[3][start + k] = 0.0;
            jacobian_left_tip[4][start + k] = 0.0;
            jacobian_left_tip[5][start + k] = 0.0;
            jacobian_left_tip[6][start + k] = 0.0;
            jacobian_left_tip[7][start + k] = 0.0;
            jacobian_left_tip[8][start + k] = 0.0;
            jacobian_left_tip[9][start + k] = 0.0;
            jacobian_left_tip[10][start + k] = 1.0;
            jacobian_left_tip[11][start + k] = 0.0;
            jacobian_right_tip[0][start + k] = 0.0;
            jacobian_right_tip[1][start + k] = -t_4;
            jacobian_right_tip[2][start + k] = 0.0;
            jacobian_right_tip[3][start + k] = t_5;
            jacobian_right_tip[4][start + k] = 0.0;
            jacobian_right_tip[5][start + k] = 0.0;
            jacobian_right_tip[6][start + k] = 0.0;
            jacobian_right_tip[7][start + k] = 0.0;
            jacobian_right_tip[8][start + k] = 0.0;
            jacobian_right_tip[9][start + k] = 0.0;
            jacobian_right_tip[10][start + k] = 0.0;
            jacobian_right_tip[11][start + k] = 1.0;
        }
    }
}
