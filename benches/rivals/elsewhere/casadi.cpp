// The functions of arms.c, which casadi_code.py had CasADi write.
#include "loop.h"

extern "C" {
typedef int Function(const double **, double **, long long *, double *, int);
#define ARM(name)                                                                                  \
  Function name##_inverse_dynamics, name##_mass_matrix, name##_coriolis_vector,                    \
      name##_gravity_vector, name##_forward_dynamics;
ARM(two_link_saha) ARM(elbow_3r) ARM(stanford) ARM(puma560) ARM(ur5) ARM(panda)
#undef ARM
}

struct CasADi {
  int n;
  Function *functions[5];

  explicit CasADi(const char *arm) {
#define ARM(name, joints)                                                                          \
  if (!std::strcmp(arm, #name))                                                                    \
    *this = CasADi{joints, {name##_inverse_dynamics, name##_mass_matrix, name##_coriolis_vector,   \
                            name##_gravity_vector, name##_forward_dynamics}};
    ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
#undef ARM
  }
  CasADi(int n, std::array<Function *, 5> f) : n(n) { std::copy(f.begin(), f.end(), functions); }

  template <int K> void call(const double *q, const double *qd, const double *x, double *result) {
    const double *arguments[] = {q, qd, x};
    functions[K](arguments, &result, nullptr, nullptr, 0);
  }
};

int main(int argc, char **argv) { return run<CasADi>(argc, argv, CANDIDATE); }
