// A Pinocchio model of an arm of ARMS_FILE, which pinocchio_arms.py writes, with its friction.
#pragma once
#include <fstream>
#include <string>

#include <pinocchio/multibody.hpp>

struct Arm {
  int n = 0;
  pinocchio::Model model;
  Eigen::VectorXd viscous, coulomb;

  explicit Arm(const std::string &wanted) {
    using namespace pinocchio;
    std::ifstream file(ARMS_FILE);
    std::string word, name;
    while (file >> word >> name >> n && name != wanted) std::getline(file, word), skip(file);
    viscous = coulomb = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd armature(n);
    double x, y, z;
    file >> x >> y >> z;
    model.gravity.linear() << x, y, z;
    JointIndex parent = 0;
    for (int i = 0; i < n; i++) {
      std::string type;
      file >> type;
      auto rotation = read<3, 3>(file);
      auto origin = read<3, 1>(file);
      double mass = read<1, 1>(file)(0);
      auto centre = read<3, 1>(file);
      auto tensor = read<3, 3>(file);
      file >> armature[i] >> viscous[i] >> coulomb[i];
      SE3 placement(rotation, origin);
      std::string joint = "joint" + std::to_string(i);
      parent = type == "RZ" ? model.addJoint(parent, JointModelRZ(), placement, joint)
                            : model.addJoint(parent, JointModelPZ(), placement, joint);
      model.appendBodyToJoint(parent, Inertia(mass, centre, tensor));
    }
    model.armature = armature;
  }

private:
  template <int R, int C> static Eigen::Matrix<double, R, C> read(std::ifstream &file) {
    Eigen::Matrix<double, R, C> m;
    for (int i = 0; i < R; i++)
      for (int j = 0; j < C; j++) file >> m(i, j);
    return m;
  }

  // Over the joints of an arm that is not wanted.
  void skip(std::ifstream &file) {
    std::string line;
    for (int i = 0; i < n; i++) std::getline(file, line);
  }
};
