
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
