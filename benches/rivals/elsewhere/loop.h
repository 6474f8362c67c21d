// Times and values of a candidate that is not Rust, in the form of src/measure.rs and src/timing.rs.
//
// A Candidate has a constructor from the arm's name, and
// template <int K> void call(q, qd, x, result): function K of FUNCTIONS, where x holds the
// accelerations, or for forward_dynamics the torques.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

static const char *const ARMS[] = {"two_link_saha", "elbow_3r", "stanford", "puma560", "ur5", "panda"};
static const char *const FUNCTIONS[] = {"inverse_dynamics", "mass_matrix", "coriolis_vector",
                                        "gravity_vector", "forward_dynamics"};
constexpr int MOST_JOINTS = 7, STATES = 64, SAMPLES = 31;

struct State {
  double q[MOST_JOINTS], qd[MOST_JOINTS], x[MOST_JOINTS];
};

// The states of src/timing.rs.
inline State state(int i) {
  State s;
  for (int joint = 0; joint < MOST_JOINTS; joint++) {
    double at = 1.7 * i + 2.3 * joint;
    s.q[joint] = 3.0 * std::sin(0.1 + at);
    s.qd[joint] = 3.0 * std::sin(0.7 + at);
    s.x[joint] = 3.0 * std::sin(1.9 + at);
  }
  return s;
}

// What is behind the pointer may have been read and written.
inline void hide(const void *p) { asm volatile("" : : "g"(p) : "memory"); }

// The median time of an evaluation.
template <class F> double median_nanoseconds(F evaluate) {
  using clock = std::chrono::steady_clock;
  auto sample = [&](int rounds) {
    auto start = clock::now();
    for (int round = 0; round < rounds; round++) evaluate();
    return std::chrono::duration<double, std::nano>(clock::now() - start).count();
  };
  int rounds = 1;
  while (sample(rounds) < 50000) rounds *= 2;
  std::vector<double> times(SAMPLES);
  for (double &time : times) time = sample(rounds);
  std::sort(times.begin(), times.end());
  return times[SAMPLES / 2] / rounds;
}

template <int K, class Candidate> double nanoseconds(Candidate &candidate) {
  std::vector<State> states(STATES);
  for (int i = 0; i < STATES; i++) states[i] = state(i);
  double result[MOST_JOINTS * MOST_JOINTS];
  auto all = [&] {
    for (State &s : states) {
      hide(&s);
      candidate.template call<K>(s.q, s.qd, s.x, result);
      hide(result);
    }
  };
  return median_nanoseconds(all) / STATES;
}

template <class With, int... K>
void time_all(const char *name, With with, std::integer_sequence<int, K...>) {
  for (const char *arm : ARMS)
    with(arm, [&](auto &candidate) {
      (std::printf("time %s %s %s %.2f\n", arm, FUNCTIONS[K], name, nanoseconds<K>(candidate)), ...);
    });
}

// For each line `ARM q... qd... qdd... tau...` the values of all five functions, exactly.
template <class With, int... K>
void print_values(const char *file, With with, std::integer_sequence<int, K...>) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string arm, word;
    words >> arm;
    std::vector<double> x;
    while (words >> word) x.push_back(std::strtod(word.c_str(), nullptr));
    int n = x.size() / 4;
    auto print = [&](const char *function, double *values, int count) {
      std::printf("%s %s", arm.c_str(), function);
      for (int i = 0; i < count; i++) std::printf(" %a", values[i]);
      std::printf("\n");
    };
    double result[MOST_JOINTS * MOST_JOINTS];
    with(arm.c_str(), [&](auto &candidate) {
      ((candidate.template call<K>(&x[0], &x[n], &x[K == 4 ? 3 * n : 2 * n], result),
        print(FUNCTIONS[K], result, K == 1 ? n * n : n)), ...);
    });
  }
}

// Prints values or times of a candidate; `with` hands that of an arm, by its name, to a function.
template <class With> int run(int argc, char **argv, const char *name, With with) {
  auto all = std::make_integer_sequence<int, 5>();
  if (argc == 3 && !std::strcmp(argv[1], "values"))
    print_values(argv[2], with, all);
  else
    time_all(name, with, all);
  return 0;
}

template <class Candidate> int run(int argc, char **argv, const char *name) {
  return run(argc, argv, name, [](const char *arm, auto then) {
    Candidate candidate(arm);
    then(candidate);
  });
}
