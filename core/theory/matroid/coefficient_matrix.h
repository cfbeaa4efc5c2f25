#pragma once

#include <optional>
#include <vector>

#include "core/foundations/exact/pi_number.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// The coefficient matrix P of the moment equations [AU, Eqs. (17)-(20), (24)]: P(c, e) = T(c, e) P_c,e,
/// where P_c,e is the component along e_c, the normal of the plane of the mesh's two axes, of the moment of
/// joint e about the pitch point.
///
/// Shape    c x t. Rows are computed on demand; nothing is stored.
/// Units    lengths of the document; normalised rows are numbers.
/// Identity P theta = 0 for every motion; a normalised row is the row of lengths divided by |P_c,e| of the
///          head's gear, and the row of tooth counts divided by N_head.
/// Cost     a row O(length of its cycle).
class CoefficientMatrix {
 public:
  struct Entry {
    JointOrdinal joint = 0;
    bool tail = false;  ///< on the axis of the tail's gear: i in a normalised row, else 1
    int sign = 1;       ///< of the entry in the normalised row
    double length = 0;  ///< the entry in the row of lengths, T P_c,e
  };

  /// @pre the model was made from this mechanism and placement, which outlive the matrix
  CoefficientMatrix(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement)
      : m_mechanism(mechanism), m_model(model), m_placement(placement) {}

  [[nodiscard]] int rows() const { return m_model.c(); }
  [[nodiscard]] int columns() const { return m_model.t(); }
  /// The non-zeros of a row, by joint.
  [[nodiscard]] std::vector<Entry> row(MeshOrdinal mesh) const;
  /// The same, appended to `entries`.
  void appendRow(MeshOrdinal mesh, std::vector<Entry>& entries) const;

  /// |P_c,e| of the joints on the tail's axis (or the head's) as a fraction; std::nullopt if it is
  /// irrational.
  [[nodiscard]] std::optional<Rational> exactRadius(MeshOrdinal mesh, bool tail) const;
  /// i of the mesh, N_tail / N_head [AU, Eq. (20)]; where one side slides, the travel or the angle of the
  /// head's side for one unit of the tail's. @pre without a power of pi
  [[nodiscard]] Rational ratio(MeshOrdinal mesh) const { return piRatio(mesh).rational(); }
  /// The same with any power of pi.
  [[nodiscard]] PiNumber piRatio(MeshOrdinal mesh) const;

 private:
  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
};

}  // namespace geargraph
