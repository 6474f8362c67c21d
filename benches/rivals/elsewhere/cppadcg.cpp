// The functions of cppadcg.c, which cppadcg_code.cpp had CppADCodeGen write.
#include "loop.h"

extern "C" {
typedef void Function(const double *, double *);
#define ARM(name)                                                                                  \
  Function name##_inverse_dynamics, name##_mass_matrix, name##_coriolis_vector,                    \
      name##_gravity_vector, name##_forward_dynamics;
ARM(two_link_saha) ARM(elbow_3r) ARM(stanford) ARM(puma560) ARM(ur5) ARM(panda)
#undef ARM
}

struct CppADCodeGen {
  int n;
  Function *functions[5];

  explicit CppADCodeGen(const char *arm) {
#define ARM(name, joints)                                                                          \
  if (!std::strcmp(arm, #name))                                                                    \
    *this = CppADCodeGen{joints, {name##_inverse_dynamics, name##_mass_matrix, name##_coriolis_vector, \
                                  name##_gravity_vector, name##_forward_dynamics}};
    ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
#undef ARM
  }
  CppADCodeGen(int n, std::array<Function *, 5> f) : n(n) { std::copy(f.begin(), f.end(), functions); }

  // All arguments of a generated function are one array.
  template <int K> void call(const double *q, const double *qd, const double *x, double *result) {
    double arguments[3 * MOST_JOINTS];
    std::copy(q, q + n, arguments);
    std::copy(qd, qd + n, arguments + n);
    std::copy(x, x + n, arguments + 2 * n);
    functions[K](arguments, result);
  }
};

int main(int argc, char **argv) { return run<CppADCodeGen>(argc, argv, CANDIDATE); }
