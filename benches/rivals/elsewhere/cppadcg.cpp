// The functions of cppadcg.c, which cppadcg_code.cpp had CppADCodeGen write.
extern "C" typedef void Function(const double *, double *);
#include "functions_of_c.h"

struct CppADCodeGen : FunctionsOfC {
  using FunctionsOfC::FunctionsOfC;

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
