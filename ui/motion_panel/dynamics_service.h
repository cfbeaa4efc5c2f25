#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/teaching/force_tables/dynamics_table.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph {

/// Angles and speeds of the inputs, rad and rad/s, in the order of the solution. Empty: the reference pose at
/// rest.
struct InputMoment {
  std::vector<double> angles;
  std::vector<double> speeds;
  friend bool operator==(const InputMoment&, const InputMoment&) = default;
};

struct DynamicsRequest {
  SnapshotPtr snapshot;
  InputMoment moment;
};

using MechanismDynamicsPtr = std::shared_ptr<const MechanismDynamics>;

/// The dynamics of a snapshot's mechanism.
struct Dynamics {
  SnapshotPtr snapshot;
  MechanismDynamicsPtr train;     ///< null: `unavailableReason` has the reason
  std::string unavailableReason;  ///< a sentence
  DynamicState state;             ///< at the requested moment
  bool isMassless = false;  ///< a motion of the inputs moves no mass, so torques determine no acceleration
  double metres = 0;        ///< in one of the document's unit
};
using DynamicsPtr = std::shared_ptr<const Dynamics>;

/// Computes the dynamics of the window's document on a background thread, while a view shows them. Masses are
/// cached between moments of the same mechanism.
class DynamicsService final : public Service<DynamicsRequest, DynamicsPtr> {
 public:
  explicit DynamicsService(QObject* parent = nullptr);
};

}  // namespace geargraph
