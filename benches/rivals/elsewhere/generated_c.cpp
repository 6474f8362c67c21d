// The functions that `robot-dynamics generate --lang c` writes, in files of their own that a C compiler compiled.
#include "loop.h"

#include "elbow_3r.h"
#include "panda.h"
#include "puma560.h"
#include "stanford.h"
#include "two_link_saha.h"
#include "ur5.h"

// An arm: its number of joints and its five functions.
#define ARM(name, n)                                                                               \
  struct name {                                                                                    \
    template <int K>                                                                               \
    inline void call(const double *q, const double *qd, const double *x, double *result) {         \
      if constexpr (K == 0) name##_inverse_dynamics(q, qd, x, result);                             \
      if constexpr (K == 1) name##_mass_matrix(q, reinterpret_cast<double(*)[n]>(result));         \
      if constexpr (K == 2) name##_coriolis_vector(q, qd, result);                                 \
      if constexpr (K == 3) name##_gravity_vector(q, result);                                      \
      if constexpr (K == 4) name##_forward_dynamics(q, qd, x, result);                             \
    }                                                                                              \
  };
namespace generated {
ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
}
#undef ARM

int main(int argc, char **argv) {
  auto with = [](const char *name, auto then) {
#define ARM(arm)                                                                                   \
  if (!std::strcmp(name, #arm)) {                                                                  \
    generated::arm candidate;                                                                      \
    then(candidate);                                                                               \
  }
    ARM(two_link_saha) ARM(elbow_3r) ARM(stanford) ARM(puma560) ARM(ur5) ARM(panda)
#undef ARM
  };
  return run(argc, argv, CANDIDATE, with);
}
