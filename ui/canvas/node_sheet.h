#pragma once

#include <utility>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph::inline canvas {

using NodeMoves = std::vector<std::pair<LinkId, SheetPoint>>;
using NoteMoves = std::vector<std::pair<NoteId, SheetPoint>>;

/// A drawing whose links stand at places that tools may change: what the tools have to know of it.
class NodeSheet {
 public:
  NodeSheet() = default;
  NodeSheet(const NodeSheet&) = delete;
  NodeSheet& operator=(const NodeSheet&) = delete;
  virtual ~NodeSheet() = default;

  /// Where the links stand now.
  [[nodiscard]] virtual const NodePositions& positions() const = 0;
  [[nodiscard]] virtual const std::vector<Outline>& outlines() const = 0;
  /// Marks over the drawing, until others are given.
  virtual void setOverlay(DisplayList overlay) = 0;

  // Where this drawing keeps places in a document.
  [[nodiscard]] virtual Expected<Mechanism> withMoved(const Mechanism& mechanism,
                                                      const NodeMoves& places) const = 0;
  [[nodiscard]] virtual Expected<Mechanism> withLinkAt(const Mechanism& mechanism, SheetPoint at) const = 0;

  /// Are the document's notes on it?
  [[nodiscard]] virtual bool showsNotes() const { return false; }
};

}  // namespace geargraph::inline canvas
