#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/dxf/arc_fit.h"

namespace geargraph {

/// A layer: its name, AutoCAD's colour number, and whether its lines are dash-dotted.
struct DxfLayer {
  std::string name;
  int color = 7;
  bool isDashDotted = false;
};

/// $INSUNITS of a unit of length by its size in metres: 4 for millimetres, 1 for inches, ...; 0 (none) for
/// one that DXF does not know.
[[nodiscard]] int dxfUnits(double metres);

/// A drawing of DXF R2000 (AC1015), model space only: closed polylines with bulges, circles, lines, texts.
class DxfFile {
 public:
  explicit DxfFile(std::vector<DxfLayer> layers) : m_layers(std::move(layers)) {}

  /// `layer`, here and below: the position in the list.
  void addPolyline(int layer, const std::vector<ArcVertex>& vertices, bool isClosed);
  void addCircle(int layer, const Eigen::Vector2d& center, double radius);
  void addLine(int layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  /// One line of text, its lower left corner at `at`. Characters beyond ASCII are written as \U+XXXX.
  void addText(int layer, const Eigen::Vector2d& at, double height, std::string_view utf8);

  /// The whole file. `units`: $INSUNITS.
  [[nodiscard]] std::string text(int units) const;

 private:
  struct Entity {
    std::string type;
    int layer = 0;
    std::string groups;  ///< after those that all entities have
  };
  void reach(const Eigen::Vector2d& point);

  std::vector<DxfLayer> m_layers;
  std::vector<Entity> m_entities;
  Eigen::Vector2d m_low = Eigen::Vector2d::Zero();
  Eigen::Vector2d m_high = Eigen::Vector2d::Zero();
  bool m_isEmpty = true;
};

}  // namespace geargraph
