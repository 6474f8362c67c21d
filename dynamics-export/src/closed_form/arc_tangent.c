static inline double arc_tangent(double square)
{
    /* Even and odd powers (FreeBSD's s_atan.c, Sun Microsystems 1993). */
    const double fourth = square * square;
    const double even = 0.016285820115365782 * fourth + 0.049768779946159324;
    const double odd = -0.036531572744216916 * fourth + -0.058335701337905735;
    const double more = (even * fourth + 0.06661073137387531) * fourth + 0.09090887133436507;
    const double others = (odd * fourth + -0.0769187620504483) * fourth + -0.11111110405462356;
    const double all = (more * fourth + 0.14285714272503466) * fourth + 0.3333333333333293;
    return all + (others * fourth + -0.19999999999876483) * square;
}
