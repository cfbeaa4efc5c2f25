#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/obstacle_grid.h"
#include "core/theory/levers/lever_plan.h"

namespace geargraph {

// The marks that levers, nomogram and plan have in common.

constexpr double kDiscRadius = 13;
constexpr double kChipRadius = 8.5;  ///< of a coupling's letter
constexpr double kValueSize = 12;
constexpr double kSmallSize = 11;

/// Where a text is wished, seen from its anchor.
enum class LetterSide { above, below, right, left };

/// Moves places on a line apart to the least distance, as near to where they were as possible. @pre ascending
void spread(std::vector<double>& places, double gap);

/// Collects the marks of a drawing and finds places for its texts: none touches another, a disc or a chip.
class LeverPainter {
 public:
  /// `area`: where marks are expected.
  LeverPainter(const Mechanism& mechanism, const Emphases& emphases, const Extent& area);

  void line(const ElementId& element, std::vector<CanvasPoint> points, const Tint& tint, double width,
            Dash dash = Dash::solid, int z = kLineDepth);
  void arrow(const ElementId& element, CanvasPoint from, CanvasPoint to, const Tint& tint, double width);
  /// The disc of the links at one point, with their labels; several are a longer one. Filled: held.
  void disc(const std::vector<LinkOrdinal>& links, CanvasPoint center, bool isFilled);
  /// A letter, white on a filled disc where the coupling is engaged.
  void chip(ShiftElementId coupling, CanvasPoint center, bool isEngaged);
  /// The ground beside a disc: a triangle on a hatched line, opening to the right.
  void ground(const ElementId& element, CanvasPoint tip);
  /// A small point, filled or open.
  void point(const ElementId& element, CanvasPoint center, bool isFilled);
  void box(const Box& shape, const Tint& fill, const Tint& border);
  /// A word in a rounded box.
  void pill(const ElementId& element, CanvasPoint anchor, LetterSide side, const std::string& word,
            bool isInput);
  /// A text near its anchor, on the first of the sides that is free, else farther off with a leader.
  void text(const ElementId& element, CanvasPoint anchor, const std::vector<LetterSide>& sides,
            const std::string& words, double size, bool bold, const Tint& tint);
  /// A text with its centre here, whatever is there.
  void fixedText(const ElementId& element, CanvasPoint center, const std::string& words, double size,
                 bool bold, const Tint& tint);

  /// Texts keep clear of it.
  void block(const Extent& box) { m_taken.addBox(box); }
  void blockLine(CanvasPoint from, CanvasPoint to) { m_taken.addCurve(Curve::straight(from, to)); }
  /// A straight line can be picked.
  void pickLine(const ElementId& element, CanvasPoint from, CanvasPoint to);
  /// Half the width of a disc with the labels of these links.
  [[nodiscard]] static double halfWidthOf(const std::vector<LinkOrdinal>& links);

  [[nodiscard]] DisplayList take();

 private:
  [[nodiscard]] Extent freePlace(CanvasPoint anchor, const std::vector<LetterSide>& sides, double halfWidth,
                                 double halfHeight) const;
  void put(const ElementId& element, MarkRole role, int z, std::variant<Stroke, Fill, Text> what);

  const Mechanism& m_mechanism;
  const Emphases& m_emphases;
  ObstacleGrid m_taken;
  DisplayList m_list;
};

}  // namespace geargraph
