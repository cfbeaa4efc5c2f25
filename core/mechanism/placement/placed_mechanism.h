#pragma once

#include <memory>

#include "core/foundations/base/deferred_value.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A mechanism with its placement, which is computed once, on first use, and shared by copies. Immutable and
/// thread-safe. Edits that keep the geometry consistent (fitting) take and return these, so that the
/// placement by which an edit is checked is the one that everything else reads. Converts to its mechanism
/// implicitly.
class PlacedMechanism {
 public:
  PlacedMechanism(MechanismPtr mechanism);  // NOLINT(google-explicit-constructor)
  PlacedMechanism(Mechanism mechanism)      // NOLINT
      : PlacedMechanism(std::make_shared<const Mechanism>(std::move(mechanism))) {}

  /// Another version of the document with the same placement: nothing is computed again.
  /// @pre they differ only in what placementOf() does not read (isSameButForView())
  [[nodiscard]] PlacedMechanism withSamePlacement(MechanismPtr mechanism) const;

  [[nodiscard]] const MechanismPtr& pointer() const { return m_mechanism; }
  [[nodiscard]] const Mechanism& mechanism() const { return *m_mechanism; }
  operator const Mechanism&() const { return *m_mechanism; }  // NOLINT(google-explicit-constructor)
  /// The reference is valid as long as any copy lives. Cost: placementOf() on the first call.
  [[nodiscard]] const Placement& placement() const { return *m_placement->get(); }

 private:
  MechanismPtr m_mechanism;
  std::shared_ptr<const DeferredValue<Placement>> m_placement;
};

/// The result of an edit with a placement still to be computed; an error is passed on.
[[nodiscard]] Expected<PlacedMechanism> unplaced(Expected<Mechanism> edited);
[[nodiscard]] inline Expected<PlacedMechanism> unplaced(Expected<PlacedMechanism> edited) {
  return edited;
}

}  // namespace geargraph
