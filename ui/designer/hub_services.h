#pragma once

#include <memory>

#include "core/design/gearboxes/hub_document.h"
#include "core/design/gearboxes/hub_search.h"
#include "core/presentation/drawing/display_list.h"
#include "ui/service/service.h"

namespace geargraph {

using HubWishPtr = std::shared_ptr<const HubWish>;
using HubSearchPtr = std::shared_ptr<const HubSearch>;

/// Searches all tooth sets of a maker's sheet.
class HubService final : public Service<HubWishPtr, HubSearchPtr> {
 public:
  explicit HubService(QObject* parent = nullptr);
};

/// A candidate as a document, and its section.
struct HubDetail {
  HubCandidate candidate;
  MechanismPtr document;
  DisplayList schematic;
};
using HubDetailPtr = std::shared_ptr<const HubDetail>;

class HubDetailService final : public Service<HubCandidate, HubDetailPtr> {
 public:
  explicit HubDetailService(QObject* parent = nullptr);
};

}  // namespace geargraph
