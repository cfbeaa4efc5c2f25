#include "core/machine/body_layout/derived_geometry.h"

#include <optional>
#include <utility>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/train/toothed_train.h"
#include "core/mechanism/placement/recentred.h"

namespace geargraph {

/// The train about its own origin, by stages, and what of it is moved to its place.
struct DerivedGeometry::Parts {
  explicit Parts(const PlacedMechanism& placed)
      : recentre([placed](const std::stop_token&) { return recentred(placed, placed.placement()); }),
        shaped(
            [this, placed](const std::stop_token& stop) { return shapedWheels(placed, near(placed), stop); }),
        stacked([this, placed](const std::stop_token& stop) {
          const auto wheels = shaped.get(stop);
          if (!wheels) return TrainWheels{};
          TrainWheels result = *wheels;
          stackWheels(result, near(placed), stop);
          return result;
        }),
        assembled([this, placed](const std::stop_token& stop) {
          const auto wheels = stacked.get(stop);
          if (!wheels) return AssembledTrain{};
          return assembledTrain(placed, near(placed), *wheels, stop);
        }),
        diagnostics([this, placed](const std::stop_token& stop) { return diagnose(placed, stop); }),
        movedWheels([this](const std::stop_token& stop) {
          const auto train = assembled.get(stop);
          return train ? moved(train->wheels, origin()) : TrainWheels{};
        }),
        movedTrain([this](const std::stop_token& stop) {
          const auto train = assembled.get(stop);
          return train ? moved(train->train, origin()) : GearTrain{};
        }),
        movedArrangement([this](const std::stop_token& stop) {
          const auto train = assembled.get(stop);
          return train ? moved(train->arrangement, origin()) : Arrangement{};
        }) {}

  [[nodiscard]] bool isElsewhere() const { return recentre.get()->has_value(); }
  [[nodiscard]] const Placement& near(const PlacedMechanism& placed) const {
    return isElsewhere() ? (*recentre.get())->placement : placed.placement();
  }
  [[nodiscard]] Eigen::Vector3d origin() const { return wide((*recentre.get())->origin); }
  [[nodiscard]] Diagnostics diagnose(const PlacedMechanism& placed, const std::stop_token& stop) const {
    const auto wheels = shaped.get(stop);
    if (!wheels) return {};
    if (wheels->wheels.size() > kMaxRoutedGears)
      return wheelDiagnostics(placed, near(placed), toothedTrain(placed, *wheels), stop);
    const auto train = assembled.get(stop);
    return train ? diagnosticsOf(placed, near(placed), *train, stop) : Diagnostics{};
  }

  DeferredValue<std::optional<Recentred>> recentre;
  DeferredValue<TrainWheels> shaped;
  DeferredValue<TrainWheels> stacked;
  DeferredValue<AssembledTrain> assembled;
  DeferredValue<Diagnostics> diagnostics;
  DeferredValue<TrainWheels> movedWheels;
  DeferredValue<GearTrain> movedTrain;
  DeferredValue<Arrangement> movedArrangement;
};

DerivedGeometry::DerivedGeometry(PlacedMechanism placed)
    : m_placed(std::move(placed)), m_parts(std::make_unique<Parts>(m_placed)) {}

DerivedGeometry::~DerivedGeometry() = default;

std::shared_ptr<const TrainWheels> DerivedGeometry::wheels(const std::stop_token& stop) const {
  if (m_parts->isElsewhere()) return m_parts->movedWheels.get(stop);
  const std::shared_ptr<const AssembledTrain> assembled = m_parts->assembled.get(stop);
  return assembled ? std::shared_ptr<const TrainWheels>(assembled, &assembled->wheels) : nullptr;
}

std::shared_ptr<const GearTrain> DerivedGeometry::train(const std::stop_token& stop) const {
  if (m_parts->isElsewhere()) return m_parts->movedTrain.get(stop);
  const std::shared_ptr<const AssembledTrain> assembled = m_parts->assembled.get(stop);
  return assembled ? std::shared_ptr<const GearTrain>(assembled, &assembled->train) : nullptr;
}

std::shared_ptr<const Arrangement> DerivedGeometry::arrangement(const std::stop_token& stop) const {
  if (m_parts->isElsewhere()) return m_parts->movedArrangement.get(stop);
  const std::shared_ptr<const AssembledTrain> assembled = m_parts->assembled.get(stop);
  return assembled ? std::shared_ptr<const Arrangement>(assembled, &assembled->arrangement) : nullptr;
}

std::shared_ptr<const Diagnostics> DerivedGeometry::diagnostics(const std::stop_token& stop) const {
  return m_parts->diagnostics.get(stop);
}

}  // namespace geargraph
