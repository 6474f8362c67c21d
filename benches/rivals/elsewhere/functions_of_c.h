// The functions of C code that has five for each arm, all of one type: two_link_saha_inverse_dynamics and so on.
// Who includes this has declared `Function`, the type.
#pragma once
#include "loop.h"

#define EACH_ARM ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
#define FIVE(name)                                                                                 \
  name##_inverse_dynamics, name##_mass_matrix, name##_coriolis_vector, name##_gravity_vector,      \
      name##_forward_dynamics

extern "C" {
#define ARM(name, joints) Function FIVE(name);
EACH_ARM
#undef ARM
}

// Those of one arm, by its name.
struct FunctionsOfC {
  int n;
  std::array<Function *, 5> functions;

  explicit FunctionsOfC(const char *arm) {
#define ARM(name, joints)                                                                          \
  if (!std::strcmp(arm, #name)) {                                                                  \
    n = joints;                                                                                    \
    functions = {FIVE(name)};                                                                      \
  }
    EACH_ARM
#undef ARM
  }
};
