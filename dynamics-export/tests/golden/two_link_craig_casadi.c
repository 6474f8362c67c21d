/**
 * Equations of motion of `two_link_craig`, written by robot-dynamics.
 *
 * For `casadi.external`. Each function is proven equal to the textbook Lagrangian. SI units, radians.
 * Entries that are zero always are no part of an output. Derivatives `jac_..`, `jac_jac_..` and `adj1_..` are exact.
 *
 * The input `arm` has the symbolic parameters, in this order: m1, m2, l1, l2, g.
 * Derivatives by them are not known: they are NaN.
 */

#ifndef ROBOT_DYNAMICS_DEVICE
#define ROBOT_DYNAMICS_DEVICE
#endif

#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__CYGWIN__)
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#else
#define CASADI_SYMBOL_EXPORT
#endif
#endif

#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-variable"
#endif

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

#include <math.h>

/** Derivatives that are not known. */
static void robot_dynamics_unknown(double *values, long long int count)
{
    long long int i;
    for (i = 0; i < count; ++i) values[i] = NAN;
}

typedef struct {
    double m1;
    double m2;
    double l1;
    double l2;
    double g;
} robot_dynamics_fields;

/* What is read where an input is not there. */
static const double robot_dynamics_zeros[5] = {0};

/* Patterns of entries: rows, columns, and 1 if all are there; else where each column starts, and the rows. */
static const long long int robot_dynamics_pattern_0[3] = {5, 1, 1};
static const long long int robot_dynamics_pattern_1[3] = {2, 1, 1};
static const long long int robot_dynamics_pattern_2[4] = {2, 1, 0, 0};
static const long long int robot_dynamics_pattern_3[3] = {2, 5, 1};
static const long long int robot_dynamics_pattern_4[3] = {2, 2, 1};
static const long long int robot_dynamics_pattern_5[8] = {2, 2, 0, 2, 3, 0, 1, 0};
static const long long int robot_dynamics_pattern_6[8] = {2, 5, 0, 0, 0, 0, 0, 0};
static const long long int robot_dynamics_pattern_7[5] = {2, 2, 0, 0, 0};
static const long long int robot_dynamics_pattern_8[3] = {10, 5, 1};
static const long long int robot_dynamics_pattern_9[3] = {10, 2, 1};
static const long long int robot_dynamics_pattern_10[5] = {10, 2, 0, 0, 0};
static const long long int robot_dynamics_pattern_11[3] = {4, 5, 1};
static const long long int robot_dynamics_pattern_12[3] = {4, 2, 1};
static const long long int robot_dynamics_pattern_13[8] = {4, 2, 0, 2, 3, 2, 3, 2};
static const long long int robot_dynamics_pattern_14[5] = {4, 2, 0, 0, 0};
static const long long int robot_dynamics_pattern_15[8] = {4, 2, 0, 0, 3, 0, 1, 2};
static const long long int robot_dynamics_pattern_16[9] = {4, 2, 0, 2, 4, 1, 2, 0, 2};
static const long long int robot_dynamics_pattern_17[4] = {5, 1, 0, 0};
static const long long int robot_dynamics_pattern_18[3] = {5, 5, 1};
static const long long int robot_dynamics_pattern_19[3] = {5, 2, 1};
static const long long int robot_dynamics_pattern_20[5] = {5, 2, 0, 0, 0};
static const long long int robot_dynamics_pattern_21[7] = {2, 2, 0, 1, 2, 1, 1};
static const long long int robot_dynamics_pattern_22[7] = {2, 2, 0, 0, 2, 0, 1};

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
 *
 * G1, G2 depend on q1, q2.
 *
 * G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
 * G2 = m2 l2 g c12
 * with c1 = cos(q1), c12 = cos(q1 + q2)
 *
 * (arm[5], q[2]) -> (gravity_vector[2])
 */
CASADI_SYMBOL_EXPORT int gravity_vector(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    const double *entries = arg[0] ? arg[0] : robot_dynamics_zeros;
    const robot_dynamics_fields fields = {entries[0], entries[1], entries[2], entries[3], entries[4]};
    const robot_dynamics_fields *arm = &fields;
    const double *q = arg[1] ? arg[1] : robot_dynamics_zeros;
    (void)res; (void)iw; (void)w; (void)mem;
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
    if (res[0]) {
        res[0][0] = t_8;
        res[0][1] = t_6;
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int gravity_vector_n_in(void) { return 2; }

CASADI_SYMBOL_EXPORT long long int gravity_vector_n_out(void) { return 1; }

CASADI_SYMBOL_EXPORT const char *gravity_vector_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *gravity_vector_name_out(long long int i)
{
    switch (i) {
    case 0: return "gravity_vector";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *gravity_vector_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *gravity_vector_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int gravity_vector_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 2;
    if (sz_res) *sz_res = 1;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 0;
    return 0;
}

/**
 * Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
 *
 * Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
 *
 * tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
 *
 * tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
 * tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
 * with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
 *
 * (arm[5], q[2], qd[2], qdd[2]) -> (tau[2])
 */
CASADI_SYMBOL_EXPORT int inverse_dynamics(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    const double *entries = arg[0] ? arg[0] : robot_dynamics_zeros;
    const robot_dynamics_fields fields = {entries[0], entries[1], entries[2], entries[3], entries[4]};
    const robot_dynamics_fields *arm = &fields;
    const double *q = arg[1] ? arg[1] : robot_dynamics_zeros;
    const double *qd = arg[2] ? arg[2] : robot_dynamics_zeros;
    const double *qdd = arg[3] ? arg[3] : robot_dynamics_zeros;
    (void)res; (void)iw; (void)w; (void)mem;
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
    if (res[0]) {
        res[0][0] = t_17;
        res[0][1] = t_16;
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int inverse_dynamics_n_in(void) { return 4; }

CASADI_SYMBOL_EXPORT long long int inverse_dynamics_n_out(void) { return 1; }

CASADI_SYMBOL_EXPORT const char *inverse_dynamics_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    case 2: return "qd";
    case 3: return "qdd";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *inverse_dynamics_name_out(long long int i)
{
    switch (i) {
    case 0: return "tau";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *inverse_dynamics_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *inverse_dynamics_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int inverse_dynamics_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 4;
    if (sz_res) *sz_res = 1;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 0;
    return 0;
}

/**
 * First derivatives of `inverse_dynamics`.
 *
 * (arm[5], q[2], qd[2], qdd[2]) -> (jac_tau_arm[2 x 5], jac_tau_q[2 x 2], jac_tau_qd[2 x 2], jac_tau_qdd[2 x 2])
 */
CASADI_SYMBOL_EXPORT int jac_inverse_dynamics(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    const double *entries = arg[0] ? arg[0] : robot_dynamics_zeros;
    const robot_dynamics_fields fields = {entries[0], entries[1], entries[2], entries[3], entries[4]};
    const robot_dynamics_fields *arm = &fields;
    const double *q = arg[1] ? arg[1] : robot_dynamics_zeros;
    const double *qd = arg[2] ? arg[2] : robot_dynamics_zeros;
    const double *qdd = arg[3] ? arg[3] : robot_dynamics_zeros;
    (void)res; (void)iw; (void)w; (void)mem;
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
    const double t_1 = p_m2 * p_l2;
    const double t_2 = p_m1 + p_m2;
    const double t_3 = p_l1 * qd_1;
    const double t_4 = qd_1 + qd_2;
    const double t_5 = qdd_1 + qdd_2;
    const double t_6 = t_4 * t_4;
    const double t_7 = p_l2 * t_1;
    const double t_8 = s_2 * t_1;
    const double t_9 = c_2 * t_1;
    const double t_10 = ROBOT_DYNAMICS_FMA(t_8, t_5, t_9 * t_6);
    const double t_11 = ROBOT_DYNAMICS_FMA(p_l1, t_2, t_9);
    const double t_12 = ROBOT_DYNAMICS_FMA(p_l1, t_9, t_7);
    const double t_13 = ROBOT_DYNAMICS_FMA(p_l1, t_11, t_12);
    const double t_14 = p_g * c_1;
    const double t_15 = p_g * s_1;
    const double t_16 = t_8 * t_14;
    const double t_17 = ROBOT_DYNAMICS_FMA(t_15, t_11, t_16);
    const double t_18 = ROBOT_DYNAMICS_FMA(t_9, t_15, t_16);
    const double t_19 = ROBOT_DYNAMICS_FMA(-qd_1, t_3, t_15);
    const double t_20 = ROBOT_DYNAMICS_FMA(p_l1, qdd_1, t_14);
    const double t_21 = ROBOT_DYNAMICS_FMA(t_8, t_20, t_9 * t_19);
    const double t_22 = 2.0 * t_8;
    const double t_23 = t_3 * t_22;
    const double t_24 = t_4 * t_22;
    const double t_25 = p_l1 * t_24;
    const double t_26 = t_23 - t_25;
    const double t_27 = ROBOT_DYNAMICS_FMA(p_l1, t_10, t_21);
    if (res[0]) robot_dynamics_unknown(res[0], 10);
    if (res[1]) {
        res[1][0] = -t_17;
        res[1][1] = -t_18;
        res[1][2] = -t_27;
        res[1][3] = -t_21;
    }
    if (res[2]) {
        res[2][0] = t_26;
        res[2][1] = t_23;
        res[2][2] = -t_25;
    }
    if (res[3]) {
        res[3][0] = t_13;
        res[3][1] = t_12;
        res[3][2] = t_12;
        res[3][3] = t_7;
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int jac_inverse_dynamics_n_in(void) { return 5; }

CASADI_SYMBOL_EXPORT long long int jac_inverse_dynamics_n_out(void) { return 4; }

CASADI_SYMBOL_EXPORT const char *jac_inverse_dynamics_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    case 2: return "qd";
    case 3: return "qdd";
    case 4: return "out_tau";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *jac_inverse_dynamics_name_out(long long int i)
{
    switch (i) {
    case 0: return "jac_tau_arm";
    case 1: return "jac_tau_q";
    case 2: return "jac_tau_qd";
    case 3: return "jac_tau_qdd";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_inverse_dynamics_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    case 4: return robot_dynamics_pattern_2;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_inverse_dynamics_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_3;
    case 1: return robot_dynamics_pattern_4;
    case 2: return robot_dynamics_pattern_5;
    case 3: return robot_dynamics_pattern_4;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int jac_inverse_dynamics_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 5;
    if (sz_res) *sz_res = 4;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 0;
    return 0;
}

/**
 * Second derivatives of `inverse_dynamics`.
 *
 * (arm[5], q[2], qd[2], qdd[2]) -> (jac_jac_tau_arm_arm[10 x 5], jac_jac_tau_arm_q[10 x 2], jac_jac_tau_arm_qd[10 x 2], jac_jac_tau_arm_qdd[10 x 2], jac_jac_tau_arm_out_tau[10 x 2], jac_jac_tau_q_arm[4 x 5], jac_jac_tau_q_q[4 x 2], jac_jac_tau_q_qd[4 x 2], jac_jac_tau_q_qdd[4 x 2], jac_jac_tau_q_out_tau[4 x 2], jac_jac_tau_qd_arm[4 x 5], jac_jac_tau_qd_q[4 x 2], jac_jac_tau_qd_qd[4 x 2], jac_jac_tau_qd_qdd[4 x 2], jac_jac_tau_qd_out_tau[4 x 2], jac_jac_tau_qdd_arm[4 x 5], jac_jac_tau_qdd_q[4 x 2], jac_jac_tau_qdd_qd[4 x 2], jac_jac_tau_qdd_qdd[4 x 2], jac_jac_tau_qdd_out_tau[4 x 2])
 */
CASADI_SYMBOL_EXPORT int jac_jac_inverse_dynamics(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    const double *entries = arg[0] ? arg[0] : robot_dynamics_zeros;
    const robot_dynamics_fields fields = {entries[0], entries[1], entries[2], entries[3], entries[4]};
    const robot_dynamics_fields *arm = &fields;
    const double *q = arg[1] ? arg[1] : robot_dynamics_zeros;
    const double *qd = arg[2] ? arg[2] : robot_dynamics_zeros;
    const double *qdd = arg[3] ? arg[3] : robot_dynamics_zeros;
    (void)res; (void)iw; (void)w; (void)mem;
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
    const double t_1 = p_m1 + p_m2;
    const double t_2 = p_l1 * t_1;
    const double t_3 = p_m2 * p_l2;
    const double t_4 = s_2 * t_3;
    const double t_5 = c_2 * t_3;
    const double t_6 = p_g * s_1;
    const double t_7 = p_g * c_1;
    const double t_8 = ROBOT_DYNAMICS_FMA(-t_5, t_7, t_4 * t_6);
    const double t_9 = ROBOT_DYNAMICS_FMA(-t_7, t_2, t_8);
    const double t_10 = p_l1 * qd_1;
    const double t_11 = qdd_1 + qdd_2;
    const double t_12 = qd_1 + qd_2;
    const double t_13 = t_12 * t_12;
    const double t_14 = ROBOT_DYNAMICS_FMA(-t_4, t_13, t_5 * t_11);
    const double t_15 = ROBOT_DYNAMICS_FMA(p_l1, qdd_1, t_7);
    const double t_16 = ROBOT_DYNAMICS_FMA(-qd_1, t_10, t_6);
    const double t_17 = ROBOT_DYNAMICS_FMA(-t_5, t_15, t_4 * t_16);
    const double t_18 = 2.0 * t_5;
    const double t_19 = t_10 * t_18;
    const double t_20 = t_12 * t_18;
    const double t_21 = p_l1 * t_20;
    const double t_22 = t_19 - t_21;
    const double t_23 = ROBOT_DYNAMICS_FMA(-p_l1, t_14, t_17);
    const double t_24 = 2.0 * t_4;
    const double t_25 = p_l1 * t_24;
    const double t_26 = 0.5 * t_25;
    if (res[0]) robot_dynamics_unknown(res[0], 50);
    if (res[1]) robot_dynamics_unknown(res[1], 20);
    if (res[2]) robot_dynamics_unknown(res[2], 20);
    if (res[3]) robot_dynamics_unknown(res[3], 20);
    if (res[5]) robot_dynamics_unknown(res[5], 20);
    if (res[6]) {
        res[6][0] = t_9;
        res[6][1] = t_8;
        res[6][2] = t_8;
        res[6][3] = t_8;
        res[6][4] = t_8;
        res[6][5] = t_8;
        res[6][6] = t_23;
        res[6][7] = t_17;
    }
    if (res[7]) {
        res[7][0] = t_22;
        res[7][1] = t_19;
        res[7][2] = -t_21;
    }
    if (res[8]) {
        res[8][0] = -t_25;
        res[8][1] = -t_26;
        res[8][2] = -t_26;
    }
    if (res[10]) robot_dynamics_unknown(res[10], 20);
    if (res[11]) {
        res[11][0] = t_22;
        res[11][1] = t_19;
        res[11][2] = -t_21;
    }
    if (res[12]) {
        res[12][0] = t_25;
        res[12][1] = -t_25;
        res[12][2] = -t_25;
        res[12][3] = -t_25;
    }
    if (res[15]) robot_dynamics_unknown(res[15], 20);
    if (res[16]) {
        res[16][0] = -t_25;
        res[16][1] = -t_26;
        res[16][2] = -t_26;
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int jac_jac_inverse_dynamics_n_in(void) { return 9; }

CASADI_SYMBOL_EXPORT long long int jac_jac_inverse_dynamics_n_out(void) { return 20; }

CASADI_SYMBOL_EXPORT const char *jac_jac_inverse_dynamics_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    case 2: return "qd";
    case 3: return "qdd";
    case 4: return "out_tau";
    case 5: return "out_jac_tau_arm";
    case 6: return "out_jac_tau_q";
    case 7: return "out_jac_tau_qd";
    case 8: return "out_jac_tau_qdd";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *jac_jac_inverse_dynamics_name_out(long long int i)
{
    switch (i) {
    case 0: return "jac_jac_tau_arm_arm";
    case 1: return "jac_jac_tau_arm_q";
    case 2: return "jac_jac_tau_arm_qd";
    case 3: return "jac_jac_tau_arm_qdd";
    case 4: return "jac_jac_tau_arm_out_tau";
    case 5: return "jac_jac_tau_q_arm";
    case 6: return "jac_jac_tau_q_q";
    case 7: return "jac_jac_tau_q_qd";
    case 8: return "jac_jac_tau_q_qdd";
    case 9: return "jac_jac_tau_q_out_tau";
    case 10: return "jac_jac_tau_qd_arm";
    case 11: return "jac_jac_tau_qd_q";
    case 12: return "jac_jac_tau_qd_qd";
    case 13: return "jac_jac_tau_qd_qdd";
    case 14: return "jac_jac_tau_qd_out_tau";
    case 15: return "jac_jac_tau_qdd_arm";
    case 16: return "jac_jac_tau_qdd_q";
    case 17: return "jac_jac_tau_qdd_qd";
    case 18: return "jac_jac_tau_qdd_qdd";
    case 19: return "jac_jac_tau_qdd_out_tau";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_jac_inverse_dynamics_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    case 4: return robot_dynamics_pattern_2;
    case 5: return robot_dynamics_pattern_6;
    case 6: return robot_dynamics_pattern_7;
    case 7: return robot_dynamics_pattern_7;
    case 8: return robot_dynamics_pattern_7;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_jac_inverse_dynamics_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_8;
    case 1: return robot_dynamics_pattern_9;
    case 2: return robot_dynamics_pattern_9;
    case 3: return robot_dynamics_pattern_9;
    case 4: return robot_dynamics_pattern_10;
    case 5: return robot_dynamics_pattern_11;
    case 6: return robot_dynamics_pattern_12;
    case 7: return robot_dynamics_pattern_13;
    case 8: return robot_dynamics_pattern_13;
    case 9: return robot_dynamics_pattern_14;
    case 10: return robot_dynamics_pattern_11;
    case 11: return robot_dynamics_pattern_15;
    case 12: return robot_dynamics_pattern_16;
    case 13: return robot_dynamics_pattern_14;
    case 14: return robot_dynamics_pattern_14;
    case 15: return robot_dynamics_pattern_11;
    case 16: return robot_dynamics_pattern_15;
    case 17: return robot_dynamics_pattern_14;
    case 18: return robot_dynamics_pattern_14;
    case 19: return robot_dynamics_pattern_14;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int jac_jac_inverse_dynamics_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 9;
    if (sz_res) *sz_res = 20;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 0;
    return 0;
}

/**
 * First derivatives of `inverse_dynamics`, transposed, times `adj_..`.
 *
 * (arm[5], q[2], qd[2], qdd[2], adj_tau[2]) -> (adj_arm[5], adj_q[2], adj_qd[2], adj_qdd[2])
 */
CASADI_SYMBOL_EXPORT int adj1_inverse_dynamics(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    double *jac_tau_q = w + 0;
    double *jac_tau_qd = w + 4;
    double *jac_tau_qdd = w + 7;
    double *jac_inverse_dynamics_places[] = {0, jac_tau_q, jac_tau_qd, jac_tau_qdd};
    if (jac_inverse_dynamics(arg, jac_inverse_dynamics_places, iw, w, mem)) return 1;
    const double *adj_tau = arg[5] ? arg[5] : robot_dynamics_zeros;
    (void)res;
    if (res[0]) robot_dynamics_unknown(res[0], 5);
    if (res[1]) {
        res[1][0] = jac_tau_q[0] * adj_tau[0] + jac_tau_q[1] * adj_tau[1];
        res[1][1] = jac_tau_q[2] * adj_tau[0] + jac_tau_q[3] * adj_tau[1];
    }
    if (res[2]) {
        res[2][0] = jac_tau_qd[0] * adj_tau[0] + jac_tau_qd[1] * adj_tau[1];
        res[2][1] = jac_tau_qd[2] * adj_tau[0];
    }
    if (res[3]) {
        res[3][0] = jac_tau_qdd[0] * adj_tau[0] + jac_tau_qdd[1] * adj_tau[1];
        res[3][1] = jac_tau_qdd[2] * adj_tau[0] + jac_tau_qdd[3] * adj_tau[1];
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int adj1_inverse_dynamics_n_in(void) { return 6; }

CASADI_SYMBOL_EXPORT long long int adj1_inverse_dynamics_n_out(void) { return 4; }

CASADI_SYMBOL_EXPORT const char *adj1_inverse_dynamics_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    case 2: return "qd";
    case 3: return "qdd";
    case 4: return "out_tau";
    case 5: return "adj_tau";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *adj1_inverse_dynamics_name_out(long long int i)
{
    switch (i) {
    case 0: return "adj_arm";
    case 1: return "adj_q";
    case 2: return "adj_qd";
    case 3: return "adj_qdd";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *adj1_inverse_dynamics_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    case 4: return robot_dynamics_pattern_2;
    case 5: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *adj1_inverse_dynamics_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int adj1_inverse_dynamics_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 6;
    if (sz_res) *sz_res = 4;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 11;
    return 0;
}

/**
 * First derivatives of `adj1_inverse_dynamics`.
 *
 * (arm[5], q[2], qd[2], qdd[2], adj_tau[2]) -> (jac_adj_arm_arm[5 x 5], jac_adj_arm_q[5 x 2], jac_adj_arm_qd[5 x 2], jac_adj_arm_qdd[5 x 2], jac_adj_arm_out_tau[5 x 2], jac_adj_arm_adj_tau[5 x 2], jac_adj_q_arm[2 x 5], jac_adj_q_q[2 x 2], jac_adj_q_qd[2 x 2], jac_adj_q_qdd[2 x 2], jac_adj_q_out_tau[2 x 2], jac_adj_q_adj_tau[2 x 2], jac_adj_qd_arm[2 x 5], jac_adj_qd_q[2 x 2], jac_adj_qd_qd[2 x 2], jac_adj_qd_qdd[2 x 2], jac_adj_qd_out_tau[2 x 2], jac_adj_qd_adj_tau[2 x 2], jac_adj_qdd_arm[2 x 5], jac_adj_qdd_q[2 x 2], jac_adj_qdd_qd[2 x 2], jac_adj_qdd_qdd[2 x 2], jac_adj_qdd_out_tau[2 x 2], jac_adj_qdd_adj_tau[2 x 2])
 */
CASADI_SYMBOL_EXPORT int jac_adj1_inverse_dynamics(const double **arg, double **res, long long int *iw, double *w, int mem)
{
    double *jac_tau_q = w + 0;
    double *jac_tau_qd = w + 4;
    double *jac_tau_qdd = w + 7;
    double *jac_inverse_dynamics_places[] = {0, jac_tau_q, jac_tau_qd, jac_tau_qdd};
    if (jac_inverse_dynamics(arg, jac_inverse_dynamics_places, iw, w, mem)) return 1;
    double *jac_jac_tau_q_q = w + 11;
    double *jac_jac_tau_q_qd = w + 19;
    double *jac_jac_tau_q_qdd = w + 22;
    double *jac_jac_tau_qd_q = w + 25;
    double *jac_jac_tau_qd_qd = w + 28;
    double *jac_jac_tau_qdd_q = w + 32;
    double *jac_jac_inverse_dynamics_places[] = {0, 0, 0, 0, 0, 0, jac_jac_tau_q_q, jac_jac_tau_q_qd, jac_jac_tau_q_qdd, 0, 0, jac_jac_tau_qd_q, jac_jac_tau_qd_qd, 0, 0, 0, jac_jac_tau_qdd_q, 0, 0, 0};
    if (jac_jac_inverse_dynamics(arg, jac_jac_inverse_dynamics_places, iw, w, mem)) return 1;
    const double *adj_tau = arg[5] ? arg[5] : robot_dynamics_zeros;
    (void)res;
    if (res[0]) robot_dynamics_unknown(res[0], 25);
    if (res[1]) robot_dynamics_unknown(res[1], 10);
    if (res[2]) robot_dynamics_unknown(res[2], 10);
    if (res[3]) robot_dynamics_unknown(res[3], 10);
    if (res[5]) robot_dynamics_unknown(res[5], 10);
    if (res[6]) robot_dynamics_unknown(res[6], 10);
    if (res[7]) {
        res[7][0] = jac_jac_tau_q_q[0] * adj_tau[0] + jac_jac_tau_q_q[1] * adj_tau[1];
        res[7][1] = jac_jac_tau_q_q[2] * adj_tau[0] + jac_jac_tau_q_q[3] * adj_tau[1];
        res[7][2] = jac_jac_tau_q_q[4] * adj_tau[0] + jac_jac_tau_q_q[5] * adj_tau[1];
        res[7][3] = jac_jac_tau_q_q[6] * adj_tau[0] + jac_jac_tau_q_q[7] * adj_tau[1];
    }
    if (res[8]) {
        res[8][0] = jac_jac_tau_q_qd[0] * adj_tau[0] + jac_jac_tau_q_qd[1] * adj_tau[1];
        res[8][1] = jac_jac_tau_q_qd[2] * adj_tau[0];
    }
    if (res[9]) {
        res[9][0] = jac_jac_tau_q_qdd[0] * adj_tau[0] + jac_jac_tau_q_qdd[1] * adj_tau[1];
        res[9][1] = jac_jac_tau_q_qdd[2] * adj_tau[0];
    }
    if (res[11]) {
        res[11][0] = jac_tau_q[0];
        res[11][1] = jac_tau_q[2];
        res[11][2] = jac_tau_q[1];
        res[11][3] = jac_tau_q[3];
    }
    if (res[12]) robot_dynamics_unknown(res[12], 10);
    if (res[13]) {
        res[13][0] = jac_jac_tau_qd_q[0] * adj_tau[0] + jac_jac_tau_qd_q[1] * adj_tau[1];
        res[13][1] = jac_jac_tau_qd_q[2] * adj_tau[0];
    }
    if (res[14]) {
        res[14][0] = jac_jac_tau_qd_qd[0] * adj_tau[1];
        res[14][1] = jac_jac_tau_qd_qd[1] * adj_tau[0];
        res[14][2] = jac_jac_tau_qd_qd[2] * adj_tau[0];
        res[14][3] = jac_jac_tau_qd_qd[3] * adj_tau[0];
    }
    if (res[17]) {
        res[17][0] = jac_tau_qd[0];
        res[17][1] = jac_tau_qd[2];
        res[17][2] = jac_tau_qd[1];
    }
    if (res[18]) robot_dynamics_unknown(res[18], 10);
    if (res[19]) {
        res[19][0] = jac_jac_tau_qdd_q[0] * adj_tau[0] + jac_jac_tau_qdd_q[1] * adj_tau[1];
        res[19][1] = jac_jac_tau_qdd_q[2] * adj_tau[0];
    }
    if (res[23]) {
        res[23][0] = jac_tau_qdd[0];
        res[23][1] = jac_tau_qdd[2];
        res[23][2] = jac_tau_qdd[1];
        res[23][3] = jac_tau_qdd[3];
    }
    return 0;
}

CASADI_SYMBOL_EXPORT long long int jac_adj1_inverse_dynamics_n_in(void) { return 10; }

CASADI_SYMBOL_EXPORT long long int jac_adj1_inverse_dynamics_n_out(void) { return 24; }

CASADI_SYMBOL_EXPORT const char *jac_adj1_inverse_dynamics_name_in(long long int i)
{
    switch (i) {
    case 0: return "arm";
    case 1: return "q";
    case 2: return "qd";
    case 3: return "qdd";
    case 4: return "out_tau";
    case 5: return "adj_tau";
    case 6: return "out_adj_arm";
    case 7: return "out_adj_q";
    case 8: return "out_adj_qd";
    case 9: return "out_adj_qdd";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const char *jac_adj1_inverse_dynamics_name_out(long long int i)
{
    switch (i) {
    case 0: return "jac_adj_arm_arm";
    case 1: return "jac_adj_arm_q";
    case 2: return "jac_adj_arm_qd";
    case 3: return "jac_adj_arm_qdd";
    case 4: return "jac_adj_arm_out_tau";
    case 5: return "jac_adj_arm_adj_tau";
    case 6: return "jac_adj_q_arm";
    case 7: return "jac_adj_q_q";
    case 8: return "jac_adj_q_qd";
    case 9: return "jac_adj_q_qdd";
    case 10: return "jac_adj_q_out_tau";
    case 11: return "jac_adj_q_adj_tau";
    case 12: return "jac_adj_qd_arm";
    case 13: return "jac_adj_qd_q";
    case 14: return "jac_adj_qd_qd";
    case 15: return "jac_adj_qd_qdd";
    case 16: return "jac_adj_qd_out_tau";
    case 17: return "jac_adj_qd_adj_tau";
    case 18: return "jac_adj_qdd_arm";
    case 19: return "jac_adj_qdd_q";
    case 20: return "jac_adj_qdd_qd";
    case 21: return "jac_adj_qdd_qdd";
    case 22: return "jac_adj_qdd_out_tau";
    case 23: return "jac_adj_qdd_adj_tau";
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_adj1_inverse_dynamics_sparsity_in(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_0;
    case 1: return robot_dynamics_pattern_1;
    case 2: return robot_dynamics_pattern_1;
    case 3: return robot_dynamics_pattern_1;
    case 4: return robot_dynamics_pattern_2;
    case 5: return robot_dynamics_pattern_1;
    case 6: return robot_dynamics_pattern_17;
    case 7: return robot_dynamics_pattern_2;
    case 8: return robot_dynamics_pattern_2;
    case 9: return robot_dynamics_pattern_2;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT const long long int *jac_adj1_inverse_dynamics_sparsity_out(long long int i)
{
    switch (i) {
    case 0: return robot_dynamics_pattern_18;
    case 1: return robot_dynamics_pattern_19;
    case 2: return robot_dynamics_pattern_19;
    case 3: return robot_dynamics_pattern_19;
    case 4: return robot_dynamics_pattern_20;
    case 5: return robot_dynamics_pattern_19;
    case 6: return robot_dynamics_pattern_3;
    case 7: return robot_dynamics_pattern_4;
    case 8: return robot_dynamics_pattern_21;
    case 9: return robot_dynamics_pattern_21;
    case 10: return robot_dynamics_pattern_7;
    case 11: return robot_dynamics_pattern_4;
    case 12: return robot_dynamics_pattern_3;
    case 13: return robot_dynamics_pattern_22;
    case 14: return robot_dynamics_pattern_4;
    case 15: return robot_dynamics_pattern_7;
    case 16: return robot_dynamics_pattern_7;
    case 17: return robot_dynamics_pattern_5;
    case 18: return robot_dynamics_pattern_3;
    case 19: return robot_dynamics_pattern_22;
    case 20: return robot_dynamics_pattern_7;
    case 21: return robot_dynamics_pattern_7;
    case 22: return robot_dynamics_pattern_7;
    case 23: return robot_dynamics_pattern_4;
    default: return 0;
    }
}

CASADI_SYMBOL_EXPORT int jac_adj1_inverse_dynamics_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w)
{
    if (sz_arg) *sz_arg = 10;
    if (sz_res) *sz_res = 24;
    if (sz_iw) *sz_iw = 0;
    if (sz_w) *sz_w = 35;
    return 0;
}

#ifdef __cplusplus
}
#endif
