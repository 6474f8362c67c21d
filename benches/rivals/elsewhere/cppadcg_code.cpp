// C code of CppADCodeGen for every arm: what Pinocchio's algorithms compute, recorded by CppAD, optimised, and
// written line by line.
//
// Usage: cppadcg_code FILE
#include <pinocchio/codegen/cppadcg.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <sstream>

#include "pinocchio_model.h"

using CG = CppAD::cg::CG<double>;
using AD = CppAD::AD<CG>;
using Vector = Eigen::Matrix<AD, Eigen::Dynamic, 1>;
using Model = pinocchio::ModelTpl<AD>;
using Data = pinocchio::DataTpl<AD>;

static const char *const ARMS[] = {"two_link_saha", "elbow_3r", "stanford", "puma560", "ur5", "panda"};
static const char *const FUNCTIONS[] = {"inverse_dynamics", "mass_matrix", "coriolis_vector",
                                        "gravity_vector", "forward_dynamics"};

Vector friction(const Arm &arm, const Vector &qd) {
  Vector force(arm.n);
  for (int i = 0; i < arm.n; i++) force[i] = arm.viscous[i] * qd[i] + arm.coulomb[i] * CppAD::sign(qd[i]);
  return force;
}

// Function k of FUNCTIONS at q, qd and x, where x holds the accelerations, or for forward_dynamics the torques.
Vector values(const Arm &arm, int k, const Vector &q, const Vector &qd, const Vector &x) {
  Model model = arm.model.cast<AD>();
  Data data(model);
  Vector zero = Vector::Zero(arm.n);
  if (k == 0) return Vector(pinocchio::rnea(model, data, q, qd, x)) + friction(arm, qd);
  if (k == 1) {
    pinocchio::crba(model, data, q, pinocchio::Convention::LOCAL);
    Eigen::Matrix<AD, Eigen::Dynamic, Eigen::Dynamic> m = data.M;
    m.triangularView<Eigen::StrictlyLower>() = m.transpose().triangularView<Eigen::StrictlyLower>();
    return Eigen::Map<Vector>(m.data(), m.size());
  }
  if (k == 2) {
    model.gravity.setZero();
    return pinocchio::rnea(model, data, q, qd, zero);
  }
  if (k == 3) return pinocchio::computeGeneralizedGravity(model, data, q);
  return pinocchio::aba(model, data, q, qd, Vector(x - friction(arm, qd)), pinocchio::Convention::LOCAL);
}

void write(std::ostream &file, const Arm &arm, const std::string &name, int k) {
  int n = arm.n;
  Vector x = Vector::Zero(3 * n);
  for (int i = 0; i < 3 * n; i++) x[i] = AD(0.1 * (i + 1));
  CppAD::Independent(x);
  Vector y = values(arm, k, x.head(n), x.segment(n, n), x.tail(n));
  CppAD::ADFun<CG> function(x, y);
  function.optimize("no_compare_op");

  CppAD::cg::CodeHandler<double> handler;
  std::vector<CG> inputs(3 * n);
  handler.makeVariables(inputs);
  std::vector<CG> outputs = function.Forward(0, inputs);
  CppAD::cg::LanguageC<double> language("double");
  CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
  std::ostringstream body;
  handler.generateCode(body, language, outputs, names);
  int temporaries = std::max<int>(1, handler.getTemporaryVariableCount());
  file << "void " << name << "(const double *x, double *y) {\n  double v[" << temporaries << "];\n"
       << body.str() << "}\n";
}

int main(int, char **argv) {
  std::ofstream file(argv[1]);
  file << "#include <math.h>\n";
  for (const char *name : ARMS) {
    Arm arm(name);
    for (int k = 0; k < 5; k++) write(file, arm, std::string(name) + "_" + FUNCTIONS[k], k);
  }
}
