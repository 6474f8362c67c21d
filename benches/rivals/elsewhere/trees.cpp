// Pinocchio on the trees of a text that trees.py writes: rnea, crba, aba. The states and the values that it is compared
// with are those of `cargo bench -p benches --bench trees -- states`.
//
// Usage: trees TREES STATES
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

using namespace pinocchio;
using Vector = Eigen::VectorXd;

constexpr int STATES = 64, SAMPLES = 31;

template <int R, int C> Eigen::Matrix<double, R, C> read(std::ifstream &file) {
  Eigen::Matrix<double, R, C> m;
  for (int i = 0; i < R; i++)
    for (int j = 0; j < C; j++) file >> m(i, j);
  return m;
}

Vector read(std::ifstream &file, int n) {
  Vector v(n);
  for (int i = 0; i < n; i++) file >> v[i];
  return v;
}

struct Tree {
  Model model;
  Vector viscous;

  // The first joint of a base that moves has no friction.
  Tree(std::ifstream &file, int n, bool floats) : viscous(Vector::Zero(n + (floats ? 6 : 0))) {
    for (int i = floats ? -1 : 0; i < n; i++) {
      JointIndex parent;
      std::string type, name = "joint" + std::to_string(i + 1);
      file >> parent >> type;
      auto axis = read<3, 1>(file);
      auto rotation = read<3, 3>(file);
      auto origin = read<3, 1>(file);
      double mass = read<1, 1>(file)(0);
      auto centre = read<3, 1>(file);
      auto tensor = read<3, 3>(file);
      double friction = read<1, 1>(file)(0);
      if (i >= 0) viscous[i + (floats ? 6 : 0)] = friction;
      SE3 place(rotation, origin);
      auto add = [&](auto joint) { return model.addJoint(parent, joint, place, name); };
      JointIndex added = type == "JointModelRX"   ? add(JointModelRX())
                         : type == "JointModelRY" ? add(JointModelRY())
                         : type == "JointModelRZ" ? add(JointModelRZ())
                         : type == "JointModelPY" ? add(JointModelPY())
                         : type == "JointModelFreeFlyer" ? add(JointModelFreeFlyer())
                                                  : add(JointModelPrismaticUnaligned(axis));
      model.appendBodyToJoint(added, Inertia(mass, centre, tensor));
    }
  }
};

struct State {
  Vector q, v, x;
};

// What is behind the pointer may have been read and written.
void hide(const void *p) { asm volatile("" : : "g"(p) : "memory"); }

// The median time of a state.
template <class F> double nanoseconds(std::vector<State> &states, F evaluate) {
  using clock = std::chrono::steady_clock;
  auto sample = [&](int rounds) {
    auto start = clock::now();
    for (int round = 0; round < rounds; round++)
      for (State &state : states) hide(&state), evaluate(state);
    return std::chrono::duration<double, std::nano>(clock::now() - start).count();
  };
  int rounds = 1;
  while (sample(rounds) < 50000) rounds *= 2;
  std::vector<double> times(SAMPLES);
  for (double &time : times) time = sample(rounds);
  std::sort(times.begin(), times.end());
  return times[SAMPLES / 2] / rounds / states.size();
}

// Where a base stands: a rotation by rows and a position, to a position and a quaternion.
Vector placed(const Vector &pose) {
  Eigen::Matrix3d rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(pose.data());
  Eigen::Quaterniond turn(rotation);
  Vector placed(7);
  placed << pose.tail(3), turn.coeffs();
  return placed;
}

// The joints of another program stand in the order of its file, Pinocchio's in that of their names.
void measure(const std::string &name, Tree &tree, const std::vector<int> &joints, bool floats, std::ifstream &file) {
  // The numbers of a base that moves come first.
  std::vector<int> order;
  for (int i = 0; i < (floats ? 6 : 0); i++) order.push_back(i);
  for (int joint : joints) order.push_back(joint + (floats ? 6 : 0));
  int n = order.size(), dof = joints.size();
  Data data(tree.model);
  Eigen::MatrixXd m(n, n);
  Vector out(n);
  auto rnea_ = [&](const State &s) {
    out = rnea(tree.model, data, s.q, s.v, s.x) + tree.viscous.cwiseProduct(s.v);
    hide(out.data());
  };
  auto crba_ = [&](const State &s) {
    crba(tree.model, data, s.q, Convention::LOCAL);
    m = data.M;
    m.triangularView<Eigen::StrictlyLower>() = m.transpose().triangularView<Eigen::StrictlyLower>();
    hide(m.data());
  };
  auto aba_ = [&](const State &s) {
    Vector tau = s.x - tree.viscous.cwiseProduct(s.v);
    out = aba(tree.model, data, s.q, s.v, tau, Convention::LOCAL);
    hide(out.data());
  };
  std::vector<State> states;
  double errors[3] = {0, 0, 0};
  for (int k = 0; k < STATES; k++) {
    auto sorted = [&](const Vector &given) {
      Vector sorted(n);
      for (int i = 0; i < n; i++) sorted[order[i]] = given[i];
      return sorted;
    };
    Vector base = floats ? placed(read(file, 12)) : Vector(0);
    Vector given = read(file, dof), q(base.size() + dof);
    q.head(base.size()) = base;
    for (int i = 0; i < dof; i++) q[base.size() + joints[i]] = given[i];
    Vector v = read(file, n), x = read(file, n);
    State state{q, sorted(v), sorted(x)};
    Vector tau = sorted(read(file, n)), matrix = read(file, n * n), qdd = sorted(read(file, n));
    auto relative = [](double error, double largest) { return error / largest; };
    rnea_(state);
    errors[0] = std::max(errors[0], relative((out - tau).cwiseAbs().maxCoeff(), tau.cwiseAbs().maxCoeff()));
    crba_(state);
    for (int i = 0; i < n; i++)
      for (int j = 0; j < n; j++) {
        double error = std::abs(m(order[i], order[j]) - matrix[n * j + i]);
        errors[1] = std::max(errors[1], relative(error, matrix.cwiseAbs().maxCoeff()));
      }
    aba_(state);
    errors[2] = std::max(errors[2], relative((out - qdd).cwiseAbs().maxCoeff(), qdd.cwiseAbs().maxCoeff()));
    states.push_back(state);
  }
  double times[3] = {nanoseconds(states, rnea_), nanoseconds(states, crba_), nanoseconds(states, aba_)};
  const char *names[3] = {"inverse_dynamics", "mass_matrix", "forward_dynamics"};
  for (int k = 0; k < 3; k++) {
    std::printf("error %s %s Pinocchio %e\n", name.c_str(), names[k], errors[k]);
    std::printf("time %s %s Pinocchio %.2f\n", name.c_str(), names[k], times[k]);
  }
}

int main(int, char **argv) {
  std::ifstream trees(argv[1]), states(argv[2]);
  std::string word, name, again;
  bool floats;
  for (int n; trees >> word >> name >> n >> floats;) {
    std::vector<int> order(n);
    for (int &place : order) trees >> place;
    Tree tree(trees, n, floats);
    states >> again >> n;
    if (again != name) return std::fprintf(stderr, "%s instead of %s\n", again.c_str(), name.c_str()), 1;
    measure(name, tree, order, floats, states);
  }
}
