#pragma once

#include <QImage>
#include <QObject>
#include <map>
#include <set>

#include "core/presentation/drawing/palette.h"
#include "ui/designer/designer_services.h"

namespace geargraph {

/// Small pictures of gearboxes. They are drawn by the thread pool when they are asked for, and kept.
class HitPictures final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// px, without the scale of the screen.
  static constexpr QSize kLevers{132, 70};
  static constexpr QSize kSchematic{132, 70};

  struct Pair {
    QImage levers;
    QImage schematic;
  };

  /// Forgets all. @param wish of the gearboxes asked for from now on
  void startAnew(GearboxWishPtr wish);
  /// Null pictures until they are drawn, when drawn() is emitted.
  [[nodiscard]] Pair of(const GearboxPtr& gearbox, Theme theme, qreal devicePixelRatio);
  /// Pictures that are being drawn.
  [[nodiscard]] bool isDrawing() const { return !m_waiting.empty(); }

 signals:
  void drawn();

 private:
  struct Look {
    Theme theme = Theme::light;
    qreal ratio = 1;
    friend bool operator==(const Look&, const Look&) = default;
  };
  void take(const GearboxPtr& gearbox, const Look& look, const Pair& pictures);

  GearboxWishPtr m_wish;
  Look m_look;  ///< of the pictures
  std::map<GearboxPtr, Pair> m_pictures;
  std::set<GearboxPtr> m_waiting;
};

}  // namespace geargraph
