
/* In front of a loop over states: no state reads what another one writes. */
#if defined(__clang__)
#define ROBOT_DYNAMICS_LANES _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define ROBOT_DYNAMICS_LANES _Pragma("GCC ivdep")
#else
#define ROBOT_DYNAMICS_LANES
#endif
