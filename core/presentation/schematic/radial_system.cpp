#include "core/presentation/schematic/radial_system.h"

#include <Eigen/Dense>
#include <cmath>

namespace geargraph {
namespace {

constexpr double kLeastShare = 0.25;  ///< of its radius that a wheel keeps
constexpr double kFits = 2e-3;        ///< profile shifts and decimals are not worth a word

}  // namespace

/// By how much the wheels miss each other.
double RadialSystem::error(const Contact& contact) const {
  const Wheel& tail = wheels[contact.tail];
  const Wheel& head = wheels[contact.head];
  const double distance = std::abs(heights[tail.axis] - heights[head.axis]);
  return distance - (contact.internal ? std::abs(tail.radius - head.radius) : tail.radius + head.radius);
}

bool RadialSystem::fits(const Contact& contact) const {
  return std::abs(error(contact)) <= kFits * (wheels[contact.tail].radius + wheels[contact.head].radius);
}

/// The stationary point of sum ((r - R)/R)^2 under the contacts kept, by its Lagrange conditions. A weak pull
/// holds heights that no contact holds.
bool RadialSystem::trySolve() {
  const auto axes = static_cast<Eigen::Index>(heights.size());
  const auto count = axes + static_cast<Eigen::Index>(wheels.size());
  std::vector<const Contact*> used;
  for (const Contact& contact : contacts) {
    if (contact.kept) used.push_back(&contact);
  }
  const auto size = count + static_cast<Eigen::Index>(used.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  double mean = 0;
  for (const Wheel& wheel : wheels) mean += wheel.radius / static_cast<double>(wheels.size());
  const double pull = 1e-6 / (mean * mean);
  for (Eigen::Index i = 0; i < axes; ++i) {
    system(i, i) = pull;
    right(i) = pull * heights[i];
  }
  for (Eigen::Index w = 0; w < count - axes; ++w) {
    const double radius = wheels[w].radius;
    system(axes + w, axes + w) = 1 / (radius * radius);
    right(axes + w) = 1 / radius;
  }
  for (std::size_t k = 0; k < used.size(); ++k) {
    const auto row = count + static_cast<Eigen::Index>(k);
    const auto put = [&](Eigen::Index column, double value) {
      system(row, column) += value;
      system(column, row) += value;
    };
    const Wheel& tail = wheels[used[k]->tail];
    const Wheel& head = wheels[used[k]->head];
    const double rise = heights[tail.axis] - heights[head.axis];
    const bool level = std::abs(rise) < 1e-6 * (tail.radius + head.radius);  // then the later axis lies above
    const double sense = (level ? tail.axis > head.axis : rise > 0) ? 1 : -1;
    put(tail.axis, sense);
    put(head.axis, -sense);
    const bool tailIsRing = used[k]->internal && tail.radius > head.radius;
    const bool headIsRing = used[k]->internal && !tailIsRing;
    put(axes + used[k]->tail, headIsRing ? 1 : -1);
    put(axes + used[k]->head, tailIsRing ? 1 : -1);
  }
  const Eigen::VectorXd found = system.completeOrthogonalDecomposition().solve(right);
  for (Eigen::Index w = 0; w < count - axes; ++w) {
    if (found(axes + w) < kLeastShare * wheels[w].radius) return false;
  }
  RadialSystem next = *this;
  for (Eigen::Index i = 0; i < axes; ++i) next.heights[i] = found(i);
  for (Eigen::Index w = 0; w < count - axes; ++w) {
    next.wheels[w].radius = found(axes + w);
  }
  for (const Contact* contact : used) {
    if (!next.fits(*contact)) return false;
  }
  next.changed = true;
  *this = next;
  return true;
}

void RadialSystem::settle(const std::stop_token& stop) {
  std::vector<Contact*> missing;
  for (Contact& contact : contacts) {
    if (contact.kept && !fits(contact)) missing.push_back(&contact);
  }
  while (!missing.empty() && !stop.stop_requested()) {
    if (wheels.size() <= kMaxWheels && trySolve()) return;
    missing.back()->kept = false;
    missing.pop_back();
  }
}

}  // namespace geargraph
