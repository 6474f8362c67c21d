static inline float arc_tangent(float square)
{
    return ((-0.08053721f * square + 0.13877678f) * square + -0.1997771f) * square + 0.3333295f;
}
