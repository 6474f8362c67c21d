// The functions of arms.c, which casadi_code.py had CasADi write.
extern "C" typedef int Function(const double **, double **, long long *, double *, int);
#include "functions_of_c.h"

struct CasADi : FunctionsOfC {
  using FunctionsOfC::FunctionsOfC;

  template <int K> void call(const double *q, const double *qd, const double *x, double *result) {
    const double *arguments[] = {q, qd, x};
    functions[K](arguments, &result, nullptr, nullptr, 0);
  }
};

int main(int argc, char **argv) { return run<CasADi>(argc, argv, CANDIDATE); }
