// The functions of trial.h, which trial_code.py had CasADi write: one state at a time, and a batch of
// states by columns in the lanes of vectors. Sines are those of the C library's vectors, libmvec.
#include "loop.h"

#include <immintrin.h>

extern "C" {
#define SINE(name, lanes) lanes name(lanes) __attribute__((const))
SINE(_ZGVdN4v_sin, __m256d);
SINE(_ZGVdN4v_cos, __m256d);
SINE(_ZGVeN8v_sin, __m512d);
SINE(_ZGVeN8v_cos, __m512d);
#undef SINE
}

#ifdef __AVX512F__
typedef __m512d Lanes;
static inline Lanes sine(Lanes x) { return _ZGVeN8v_sin(x); }
static inline Lanes cosine(Lanes x) { return _ZGVeN8v_cos(x); }
#else
typedef __m256d Lanes;
#endif
static inline __m256d sine(__m256d x) { return _ZGVdN4v_sin(x); }
static inline __m256d cosine(__m256d x) { return _ZGVdN4v_cos(x); }
constexpr int LANES = sizeof(Lanes) / sizeof(double);

template <class V> static inline V load(const double *x) {
  V v;
  std::memcpy(&v, x, sizeof v);
  return v;
}
template <class V> static inline void store(double *x, V v) { std::memcpy(x, &v, sizeof v); }

static inline double sign(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }
template <class V> static inline V sign(V x) {
  V zero = {}, one = zero + 1.0;
  return x > zero ? one : x < zero ? -one : zero;
}

#include "trial.h"

// Sines and cosines of the positions at q, behind which other numbers lie.
template <class V> static inline void some_sines(const double *q, double *s, double *c) {
  V x = load<V>(q);
  store(s, sine(x));
  store(c, cosine(x));
}

template <int N> static inline void sines(const double *q, double *s, double *c) {
  for (int i = 0; i < N; i += 4) some_sines<__m256d>(q + i, s + i, c + i);
}

struct Columns {
  alignas(64) double q[MOST_JOINTS][STATES], qd[MOST_JOINTS][STATES], x[MOST_JOINTS][STATES];
  alignas(64) double result[MOST_JOINTS * MOST_JOINTS][STATES];
};

// An arm: its number of joints, its five functions, and these in lanes.
#define ARM(name, joints)                                                                          \
  struct name {                                                                                    \
    static constexpr int n = joints;                                                               \
    template <int K, class T>                                                                      \
    static inline void at(const T *q, const T *s, const T *c, const T *qd, const T *x, T *result) {\
      if constexpr (K == 0) name##_0(q, s, c, qd, x, result);                                      \
      if constexpr (K == 1) name##_1(q, s, c, qd, x, result);                                      \
      if constexpr (K == 2) name##_2(q, s, c, qd, x, result);                                      \
      if constexpr (K == 3) name##_3(q, s, c, qd, x, result);                                      \
      if constexpr (K == 4) name##_4(q, s, c, qd, x, result);                                      \
    }                                                                                              \
    template <int K>                                                                               \
    inline void call(const double *q, const double *qd, const double *x, double *result) {         \
      alignas(64) double s[8], c[8];                                                               \
      sines<n>(q, s, c);                                                                           \
      at<K>(q, s, c, qd, x, result);                                                               \
    }                                                                                              \
    template <int K> void batch(Columns &columns) {                                                \
      for (int i = 0; i < STATES; i += LANES) {                                                    \
        Lanes q[n], s[n], c[n], qd[n], x[n], result[K == 1 ? n * n : n];                           \
        for (int j = 0; j < n; j++) {                                                              \
          q[j] = load<Lanes>(&columns.q[j][i]);                                                    \
          s[j] = sine(q[j]), c[j] = cosine(q[j]);                                                  \
          qd[j] = load<Lanes>(&columns.qd[j][i]), x[j] = load<Lanes>(&columns.x[j][i]);            \
        }                                                                                          \
        at<K>(q, s, c, qd, x, result);                                                             \
        for (int j = 0; j < (K == 1 ? n * n : n); j++) store(&columns.result[j][i], result[j]);    \
      }                                                                                            \
    }                                                                                              \
  };
namespace trial {
ARM(two_link_saha, 2) ARM(elbow_3r, 3) ARM(stanford, 6) ARM(puma560, 6) ARM(ur5, 6) ARM(panda, 7)
}
#undef ARM

template <class Arm, int K> void time_batch(const char *name) {
  static Columns columns;
  for (int i = 0; i < STATES; i++) {
    State s = state(i);
    for (int j = 0; j < Arm::n; j++)
      columns.q[j][i] = s.q[j], columns.qd[j][i] = s.qd[j], columns.x[j][i] = s.x[j];
  }
  Arm arm;
  arm.template batch<K>(columns);
  double largest = 0, difference = 0;
  for (int i = 0; i < STATES; i++) {
    State s = state(i);
    double result[MOST_JOINTS * MOST_JOINTS];
    arm.template call<K>(s.q, s.qd, s.x, result);
    for (int j = 0; j < (K == 1 ? Arm::n * Arm::n : Arm::n); j++) {
      largest = std::max(largest, std::abs(result[j]));
      difference = std::max(difference, std::abs(result[j] - columns.result[j][i]));
    }
  }
  if (!(difference < 1e-9 * largest)) std::fprintf(stderr, "%s: lanes differ\n", name), std::abort();
  double time = median_nanoseconds([&] {
    hide(&columns);
    arm.template batch<K>(columns);
    hide(&columns);
  });
  std::printf("time %s %s_batch %s %.3f\n", name, FUNCTIONS[K], CANDIDATE, time / STATES);
}

template <class Arm, int... K> void time_batches(const char *name, std::integer_sequence<int, K...>) {
  (time_batch<Arm, K>(name), ...);
}

int main(int argc, char **argv) {
  auto with = [](const char *name, auto then) {
#define ARM(arm)                                                                                   \
  if (!std::strcmp(name, #arm)) {                                                                  \
    trial::arm candidate;                                                                          \
    then(candidate);                                                                               \
  }
    ARM(two_link_saha) ARM(elbow_3r) ARM(stanford) ARM(puma560) ARM(ur5) ARM(panda)
#undef ARM
  };
  run(argc, argv, CANDIDATE, with);
  if (argc > 1) return 0;
  for (const char *name : ARMS)
    with(name, [&](auto arm) {
      time_batches<decltype(arm)>(name, std::make_integer_sequence<int, 5>());
    });
}
