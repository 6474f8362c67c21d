
#ifndef ROBOT_DYNAMICS_FMA
#if defined(__FMA__) || defined(__aarch64__)
#define ROBOT_DYNAMICS_FMA(a, b, c) BUILTIN(a, b, c)
#else
#define ROBOT_DYNAMICS_FMA(a, b, c) ((a) * (b) + (c))
#endif
#endif
