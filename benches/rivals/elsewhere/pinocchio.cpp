// Pinocchio on the arms of ARMS_FILE: rnea, crba, computeGeneralizedGravity, aba.
#include "loop.h"

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "pinocchio_model.h"

using namespace pinocchio;

struct Pinocchio {
  int n;
  Model model;
  Data data;
  Eigen::VectorXd viscous, coulomb, zero;

  explicit Pinocchio(const Arm &arm)
      : n(arm.n), model(arm.model), data(model), viscous(arm.viscous), coulomb(arm.coulomb),
        zero(Eigen::VectorXd::Zero(n)) {}
  explicit Pinocchio(const char *wanted) : Pinocchio(Arm(wanted)) {}

  template <int K> void call(const double *q_, const double *qd_, const double *x_, double *out) {
    using Vector = Eigen::Map<const Eigen::VectorXd>;
    Vector q(q_, n), qd(qd_, n), x(x_, n);
    Eigen::Map<Eigen::VectorXd> result(out, n);
    if constexpr (K == 0) result = rnea(model, data, q, qd, x), add_friction(qd, result, 1);
    if constexpr (K == 1) {
      crba(model, data, q, Convention::LOCAL);
      Eigen::Map<Eigen::MatrixXd> m(out, n, n);
      m = data.M;
      m.triangularView<Eigen::StrictlyLower>() = m.transpose().triangularView<Eigen::StrictlyLower>();
    }
    // V is what the recursion gives beyond gravity; Pinocchio has no function of its own for it.
    if constexpr (K == 2) {
      Motion gravity = model.gravity;
      model.gravity.setZero();
      result = rnea(model, data, q, qd, zero);
      model.gravity = gravity;
    }
    if constexpr (K == 3) result = computeGeneralizedGravity(model, data, q);
    if constexpr (K == 4) {
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MOST_JOINTS, 1> tau = x;
      add_friction(qd, tau, -1);
      result = aba(model, data, q, qd, tau, Convention::LOCAL);
    }
  }

  template <class Q, class T> void add_friction(const Q &qd, T &&tau, double sign) {
    for (int i = 0; i < n; i++) {
      double direction = (qd[i] > 0) - (qd[i] < 0);
      tau[i] += sign * (viscous[i] * qd[i] + coulomb[i] * direction);
    }
  }
};

int main(int argc, char **argv) { return run<Pinocchio>(argc, argv, CANDIDATE); }
