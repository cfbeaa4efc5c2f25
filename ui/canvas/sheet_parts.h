#pragma once

#include <QRectF>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/presentation/drawing/display_list.h"

namespace geargraph::inline canvas {

/// A drawing taken apart: a part is the marks of one element at one depth. A value without a scene, so that
/// any thread can make one.
class SheetParts {
 public:
  struct Part {
    ElementId element;
    std::vector<Mark> marks;  ///< empty: the part is gone
    QRectF bounds;            ///< on the sheet
    quint64 drawing = 0;      ///< the last one that it was in
  };
  /// Painted in the order of their depths, and within one in that in which they came.
  using Layers = std::map<int, std::vector<Part>>;

  SheetParts() = default;
  /// The marks of a whole drawing.
  explicit SheetParts(std::vector<Mark> marks);

  /// Another content of a part, nothing for empty marks. Returns the area to be painted again, null if
  /// nothing differs. Cost: of the marks alone.
  QRectF set(const ElementId& element, int depth, std::vector<Mark> marks);

  /// All parts of an element at once; those at depths that `marks` has none of vanish. The area to be painted
  /// again, as above.
  QRectF setElement(const ElementId& element, std::vector<Mark> marks);

  /// Parts that are not set after this vanish with endDrawing(), which returns their area.
  void beginDrawing() { ++m_drawing; }
  QRectF endDrawing();

  [[nodiscard]] const Layers& layers() const { return m_layers; }
  [[nodiscard]] std::size_t count(int depth) const;
  [[nodiscard]] std::size_t count() const;
  /// The area of all parts but those of `without`, a depth. Cost: O(parts).
  [[nodiscard]] QRectF bounds(int without) const;

 private:
  void closeHoles(int depth);

  Layers m_layers;
  std::map<int, std::unordered_map<ElementId, std::size_t>> m_places;  ///< of the parts in their layers
  quint64 m_drawing = 0;
};

}  // namespace geargraph::inline canvas
