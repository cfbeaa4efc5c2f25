#pragma once

#include <utility>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph {

using NodeMoves = std::vector<std::pair<LinkId, CanvasPoint>>;
using NoteMoves = std::vector<std::pair<NoteId, CanvasPoint>>;

/// The interface of a drawing with movable nodes, for tools.
class NodeSheet {
 public:
  NodeSheet() = default;
  NodeSheet(const NodeSheet&) = delete;
  NodeSheet& operator=(const NodeSheet&) = delete;
  virtual ~NodeSheet() = default;

  /// The current places of the links.
  [[nodiscard]] virtual const NodePositions& positions() const = 0;
  [[nodiscard]] virtual const std::vector<Outline>& outlines() const = 0;
  /// Replaces the marks over the drawing.
  virtual void setOverlay(DisplayList overlay) = 0;

  // Edits of the places that the document stores for this drawing.
  [[nodiscard]] virtual Expected<Mechanism> withMoved(const Mechanism& mechanism,
                                                      const NodeMoves& places) const = 0;
  [[nodiscard]] virtual Expected<Mechanism> withLinkAt(const Mechanism& mechanism, CanvasPoint at) const = 0;

  /// Does this drawing show the document's notes?
  [[nodiscard]] virtual bool showsNotes() const { return false; }
};

}  // namespace geargraph
