
#include <stdint.h>
#include <string.h>

/** The bits of a float. */
ROBOT_DYNAMICS_DEVICE static uint32_t robot_dynamics_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/** The last 24 bits of a number, in units of 2^exponent. */
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_scaled(uint64_t number, int32_t exponent)
{
    const uint32_t bits = (uint32_t)(127 + exponent) << 23;
    float unit;
    memcpy(&unit, &bits, sizeof unit);
    return (float)(int32_t)(number & 0xffffffu) * unit;
}

/**
 * x = n pi/2 + rest - excess for a finite x of at least 2^13 (Payne and Hanek 1983): returns a number that ends in the
 * last two bits of n.
 */
ROBOT_DYNAMICS_DEVICE static uint32_t robot_dynamics_reduce_large(float x, float *rest, float *excess)
{
    /* The bits of 2/pi behind 32 zeros, the binary point behind these. */
    const uint32_t two_over_pi[8] = {
        0u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu
    };
    const uint32_t bits = robot_dynamics_bits(x);
    const uint64_t m = (bits & 0x7fffffu) | 0x800000u;
    const uint32_t start = 32u + (bits >> 23) - 152u;
    uint64_t window[3], quarters, fraction, product;
    uint32_t n, word;
    int32_t zeros = 0;
    for (word = 0; word < 3; ++word) {
        const uint64_t both = (uint64_t)two_over_pi[start / 32u + word] << 32 | two_over_pi[start / 32u + word + 1u];
        window[word] = (both << (start % 32u)) >> 32;
    }
    /* Two bits of whole quarter turns, and 62 behind the point. */
    product = m * window[1] + (m * window[2] >> 32);
    quarters = (m * window[0] + (product >> 32)) << 32 | (product & 0xffffffffu);
    n = (uint32_t)((quarters + ((uint64_t)1 << 61)) >> 62);
    fraction = quarters - ((uint64_t)n << 62);
    if (fraction >> 63) {
        fraction = 0u - fraction;
        x = -x;
    }
    for (; zeros < 63 && !(fraction >> 63); ++zeros) fraction <<= 1;
    /* pi/2 in units of 2^-31. */
    product = (fraction >> 32) * 0xc90fdaa2u;
    *rest = robot_dynamics_scaled(product >> 40, 40 - 61 - zeros);
    *excess = -robot_dynamics_scaled(product >> 16, 16 - 61 - zeros);
    if (x < 0.0f) {
        *rest = -*rest;
        *excess = -*excess;
    }
    return n;
}

/** Sine and cosine: less than a unit in the last place off, NaN of what is not finite. */
ROBOT_DYNAMICS_DEVICE static void robot_dynamics_sin_cosf(float x, float *sine, float *cosine)
{
    float r, d, z, w, zz, cube, lower, s, c;
    uint32_t n;
    if (x >= -1e4f && x <= 1e4f) {
        /* Cody and Waite 1980: pi/2 in three parts whose products with n are exact, and the rest. */
        const float shifted = x * 0.63661975f + 12582912.0f;
        const float turns = shifted - 12582912.0f;
        const float second = (x - turns * 1.5703125f) - turns * 0.0004837513f;
        const float third = turns * 7.5495336e-8f;
        n = robot_dynamics_bits(shifted);
        r = second - third;
        d = turns * 2.563344e-12f + ((r - second) + third);
    } else {
        const float size = x < 0.0f ? -x : x;
        if (!(size <= 3.4028235e38f)) {
            *sine = *cosine = x - x;
            return;
        }
        n = robot_dynamics_reduce_large(size, &r, &d);
    }
    /* sin (r - d) and cos (r - d) by minimax polynomials; the rounding of w = 1 - z/2 is made good. */
    z = r * r;
    w = 1.0f - 0.5f * z;
    cube = r * z;
    s = r - ((cube * 0.16666655f + d * w) + (z * cube) * (-0.008332187f + z * 0.00019517897f));
    zz = z * z;
    lower = zz * (0.041666646f + z * -0.0013887301f) + (((1.0f - w) - 0.5f * z) + r * d);
    c = w + (lower + (zz * zz) * 2.443067e-5f);
    /* A quarter turn: (s, c) -> (c, -s). */
    *sine = n & 1u ? c : s;
    *cosine = n & 1u ? s : c;
    if (n & 2u) *sine = -*sine;
    if ((n ^ n >> 1) & 1u) *cosine = -*cosine;
    if (x < -1e4f) *sine = -*sine;
}
