
/** The last 24 bits of a number, in units of 2^exponent. */
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_scaled(uint64_t number, int32_t exponent)
{
    robot_dynamics_number_1 unit;
    unit.bits = (uint32_t)(127 + exponent) << 23;
    return (float)(int32_t)(number & 0xffffffu) * unit.real;
}

/**
 * x = n pi/2 + rest - excess for a finite x of at least 2^13 (Payne and Hanek 1983): `n` ends in the last two bits of n.
 */
ROBOT_DYNAMICS_DEVICE static void robot_dynamics_reduce_large(float x, float *n, float *rest, float *excess)
{
    /* The bits of 2/pi behind 32 zeros, the binary point behind these. */
    static const uint32_t two_over_pi[8] = {
        0u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu
    };
    uint64_t m, window[3], quarters, fraction, product;
    uint32_t start, word;
    int32_t zeros = 0;
    int is_negative;
    robot_dynamics_number_1 angle, turns;
    angle.real = x;
    m = (angle.bits & 0x7fffffu) | 0x800000u;
    start = 32u + (angle.bits >> 23) - 152u;
    for (word = 0; word < 3u; ++word) {
        const uint32_t *at = two_over_pi + start / 32u + word;
        window[word] = (((uint64_t)at[0] << 32 | at[1]) << start % 32u) >> 32;
    }
    /* Two bits of whole quarter turns, and 62 behind the point. */
    product = m * window[1] + (m * window[2] >> 32);
    quarters = (m * window[0] + (product >> 32)) << 32 | (product & 0xffffffffu);
    turns.bits = (uint32_t)((quarters + ((uint64_t)1 << 61)) >> 62);
    fraction = quarters - ((uint64_t)turns.bits << 62);
    is_negative = fraction >> 63 != 0u;
    if (is_negative) fraction = 0u - fraction;
    for (; zeros < 63 && !(fraction >> 63); ++zeros) fraction <<= 1;
    /* pi/2 in units of 2^-31. */
    product = (fraction >> 32) * 0xc90fdaa2u;
    *n = turns.real;
    *rest = robot_dynamics_scaled(product >> 40, 40 - 61 - zeros);
    *excess = -robot_dynamics_scaled(product >> 16, 16 - 61 - zeros);
    if (is_negative) {
        *rest = -*rest;
        *excess = -*excess;
    }
}
