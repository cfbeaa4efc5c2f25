#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/design/gearboxes/gearbox_document.h"
#include "core/design/gearboxes/gearbox_run.h"
#include "core/presentation/drawing/display_list.h"
#include "ui/service/service.h"

namespace geargraph {

using GearboxWishPtr = std::shared_ptr<const GearboxWish>;
using GearboxPtr = std::shared_ptr<const Gearbox>;

/// A search from its beginning, or from where it was paused.
struct DesignRequest {
  GearboxWishPtr wish;
  std::int64_t from = 0;  ///< layouts before are done
};

/// What a search has added since its last answer.
struct DesignProgress {
  std::int64_t done = 0;  ///< layouts, from the first of the list
  std::int64_t total = 0;
  std::vector<GearboxPtr> found;  ///< with losses and circulating power
  JudgeCounts judged = {};        ///< what came near, and why it was dropped
  bool isProof = false;           ///< nothing was left out: GearboxSearch::isComplete
};

/// Searches for gearboxes on threads of its own; each answer is a part, the last one ends the search. What
/// is under way when it is cancelled is lost: it goes on from the `done` of the last answer.
class DesignService final : public Service<DesignRequest, DesignProgress> {
 public:
  explicit DesignService(QObject* parent = nullptr);
};

/// What is shown of one gearbox beside its own numbers.
struct HitDetail {
  GearboxPtr asked;
  GearboxPtr gearbox;  ///< the same with losses
  Mechanism document;
  DisplayList levers;  ///< bars and points alone, as they have to be small
  DisplayList schematic;
};
using HitDetailPtr = std::shared_ptr<const HitDetail>;

struct HitRequest {
  GearboxWishPtr wish;
  std::vector<GearboxPtr> gearboxes;
};

/// The documents, losses, levers and schematics of the gearboxes asked for last, each an answer of its own.
class HitService final : public Service<HitRequest, HitDetailPtr> {
 public:
  explicit HitService(QObject* parent = nullptr);
};

}  // namespace geargraph
