// The functions that `robot-dynamics generate --lang c` writes, in files of their own that a C compiler compiled. With
// the argument `batches`, those over columns of states.
#include "loop.h"

#include "elbow_3r.h"
#include "panda.h"
#include "puma560.h"
#include "stanford.h"
#include "two_link_saha.h"
#include "ur5.h"

// The states of loop.h by columns, and room for results.
struct Columns {
  double memory[3 + MOST_JOINTS][MOST_JOINTS][STATES];
  const double *q[MOST_JOINTS], *qd[MOST_JOINTS], *x[MOST_JOINTS];
  double *result[MOST_JOINTS * MOST_JOINTS];

  Columns() {
    for (int joint = 0; joint < MOST_JOINTS; joint++) {
      q[joint] = memory[0][joint], qd[joint] = memory[1][joint], x[joint] = memory[2][joint];
      for (int i = 0; i < STATES; i++) {
        State s = state(i);
        memory[0][joint][i] = s.q[joint], memory[1][joint][i] = s.qd[joint], memory[2][joint][i] = s.x[joint];
      }
    }
    for (int i = 0; i < MOST_JOINTS * MOST_JOINTS; i++) result[i] = memory[3 + i / MOST_JOINTS][i % MOST_JOINTS];
  }
};

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
    template <int K> inline void batch(Columns &c) {                                               \
      if constexpr (K == 0) name##_inverse_dynamics_batch(c.q, c.qd, c.x, c.result, STATES);       \
      if constexpr (K == 1) name##_mass_matrix_batch(c.q, c.result, STATES);                       \
      if constexpr (K == 2) name##_coriolis_vector_batch(c.q, c.qd, c.result, STATES);             \
      if constexpr (K == 3) name##_gravity_vector_batch(c.q, c.result, STATES);                    \
      if constexpr (K == 4) name##_forward_dynamics_batch(c.q, c.qd, c.x, c.result, STATES);       \
    }                                                                                              \
  };
namespace generated {
ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
}
#undef ARM

template <class With, int... K> void time_batches(With with, std::integer_sequence<int, K...>) {
  static Columns columns;
  for (const char *arm : ARMS)
    with(arm, [&](auto &candidate) {
      auto time = [&](const char *function, auto evaluate) {
        auto all = [&] { hide(&columns), evaluate(), hide(&columns); };
        std::printf("time %s %s_batch %s %.3f\n", arm, function, CANDIDATE, median_nanoseconds(all) / STATES);
      };
      (time(FUNCTIONS[K], [&] { candidate.template batch<K>(columns); }), ...);
    });
}

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
  if (argc == 2 && !std::strcmp(argv[1], "batches")) {
    time_batches(with, std::make_integer_sequence<int, 5>());
    return 0;
  }
  return run(argc, argv, CANDIDATE, with);
}
