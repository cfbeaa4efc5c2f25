#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/presentation/diagrams/lever_layout.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/schematic/schematic.h"
#include "ui/service/service.h"

namespace geargraph {

/// The drawings of the tab.
enum class LeversPage { levers, nomogram, plan, speedPlan };

struct LeversRequest {
  SnapshotPtr snapshot;
  LeversPage page = LeversPage::levers;
};

/// What a page is drawn of; the parts of other pages are empty.
struct DrawnLevers {
  SnapshotPtr snapshot;
  LeversPage page = LeversPage::levers;

  LeverPicture picture;
  LeverLayout layout;
  /// By driven joint, as in `inputs`, the speeds of the links (by position in picture.plan.links) when it
  /// turns at 1 rad/s and the others stand; empty above kMaxDraggedInputs.
  std::vector<std::vector<Rational>> perInput;
  std::vector<int> inputs;       ///< driven joints
  std::vector<Rational> speeds;  ///< of `inputs`, rad/s
  /// The freedom that is left when one engaged coupling is let go.
  std::vector<std::pair<ShiftElementOrdinal, int>> freedomWithout;

  StatesOnLevers states;
  LeverPlan points;

  SpeedPlan speedPlan;
  SchematicGeometry section;  ///< empty where there is no speed plan
};
using DrawnLeversPtr = std::shared_ptr<const DrawnLevers>;

/// With more inputs no tip is dragged.
constexpr std::size_t kMaxDraggedInputs = 16;

/// Makes ready what the pages are drawn of, on a background thread.
class LeversService final : public Service<LeversRequest, DrawnLeversPtr> {
 public:
  explicit LeversService(QObject* parent = nullptr);
};

}  // namespace geargraph
