#pragma once

#include <QRectF>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// A drawing divided into parts: a part has the marks of one element at one depth. A value independent of a
/// scene, so that any thread can make one.
class SheetParts {
 public:
  struct Part {
    ElementId element;
    std::vector<Mark> marks;  ///< empty: the part was removed
    QRectF bounds;            ///< on the sheet
    quint64 drawing = 0;      ///< the last one that it was in
  };
  /// By depth in painting order, within a depth in the order of insertion.
  using Layers = std::map<int, std::vector<Part>>;

  SheetParts() = default;
  /// The marks of a whole drawing.
  explicit SheetParts(std::vector<Mark> marks);

  /// Replaces a part; empty marks remove it. Returns the area to be repainted, null if nothing has changed.
  /// Cost: that of the marks.
  QRectF set(const ElementId& element, int depth, std::vector<Mark> marks);

  /// Replaces all parts of an element; parts at depths without marks are removed. Returns the area to be
  /// repainted.
  QRectF setElement(const ElementId& element, std::vector<Mark> marks);

  /// Parts that are not set between this and endDrawing() are removed by endDrawing(), which returns their
  /// area.
  void beginDrawing() { ++m_drawing; }
  QRectF endDrawing();

  [[nodiscard]] const Layers& layers() const { return m_layers; }
  [[nodiscard]] std::size_t count(int depth) const;
  [[nodiscard]] std::size_t count() const;
  /// The extent of all parts except those at the depth `without`. Cost: O(parts).
  [[nodiscard]] QRectF bounds(int without) const;

 private:
  void closeHoles(int depth);

  Layers m_layers;
  std::map<int, std::unordered_map<ElementId, std::size_t>> m_places;  ///< of the parts in their layers
  quint64 m_drawing = 0;
};

}  // namespace geargraph
