#include "tests/quality/rolling_rates.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace geargraph::test {

using Eigen::Vector3d;

Eigen::VectorXd rollingRates(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                             const std::vector<double>& wanted) {
  const JointTree& tree = *placement.tree;
  const int t = mechanism.t();
  Eigen::MatrixXd slip = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(train.meshes.size()), t);
  for (std::size_t m = 0; m < train.meshes.size(); ++m) {
    const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(train.meshes[m].mesh)];
    for (const auto& [link, sign] : {std::pair{geometry.tail, 1.0}, std::pair{geometry.head, -1.0}}) {
      for (int at = link; at != 0; at = tree.parent[static_cast<std::size_t>(at)]) {
        const int j = tree.joint[static_cast<std::size_t>(at)];
        const AxisLine& line =
            placement.axes[static_cast<std::size_t>(tree.axisOf[static_cast<std::size_t>(j)])];
        const Vector3d u(line.direction[0], line.direction[1], line.direction[2]);
        const Vector3d p(line.point[0], line.point[1], line.point[2]);
        const double sense = tree.joints[static_cast<std::size_t>(j)].head == at ? 1 : -1;
        slip.block<3, 1>(3 * static_cast<Eigen::Index>(m), j) +=
            sign * sense * u.cross(train.meshes[m].pitchPoint - p);
      }
    }
  }
  // Rates nearest to the wanted ones among those without slip.
  Eigen::FullPivLU<Eigen::MatrixXd> solver(slip);
  solver.setThreshold(1e-6);
  const Eigen::MatrixXd kernel = solver.kernel();
  Eigen::VectorXd goal = Eigen::VectorXd::Zero(t);
  for (std::size_t j = 0; j < std::min(wanted.size(), static_cast<std::size_t>(t)); ++j)
    goal[static_cast<Eigen::Index>(j)] = wanted[j];
  return kernel * (kernel.transpose() * kernel).ldlt().solve(kernel.transpose() * goal);
}

}  // namespace geargraph::test
