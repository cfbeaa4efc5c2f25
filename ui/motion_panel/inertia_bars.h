#pragma once

#include <QWidget>
#include <vector>

#include "ui/document/selection.h"
#include "ui/motion_panel/dynamics_service.h"

namespace geargraph {

/// The reflected inertia at each motor as a stacked bar of the links' shares. A part is labelled if there is
/// room, explained in a tool tip, linked with the selection, and chosen by a click or the arrow keys.
class InertiaBars : public QWidget {
  Q_OBJECT

 public:
  explicit InertiaBars(Selection* selection, QWidget* parent = nullptr);

  /// Shows the dynamics; null: no bars.
  void show(const DynamicsPtr& dynamics);

  struct Part {
    ElementId link;
    int label = 0;
    int color = 0;       ///< its number
    double inertia = 0;  ///< kg m²
    double before = 0;   ///< the share of the parts before it, 0..1
    double share = 0;    ///< 0..1
  };
  struct Bar {
    ElementId joint;
    QString title;  ///< "joint 8"
    double inertia = 0;
    std::vector<Part> parts;  ///< of the links with a share, in order
  };
  [[nodiscard]] const std::vector<Bar>& bars() const { return m_bars; }
  [[nodiscard]] QRectF placeOf(std::size_t bar, std::size_t part) const;
  /// "Link 3: 0.0012 kg m² at joint 8, 41.3 % of all."
  [[nodiscard]] QString tipOf(std::size_t bar, std::size_t part) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Place {
    std::size_t bar = 0;
    std::size_t part = 0;
  };
  [[nodiscard]] static QString sumOf(const Bar& bar);
  void measure();
  [[nodiscard]] int rowHeight() const;
  [[nodiscard]] QRectF barAt(std::size_t bar) const;
  [[nodiscard]] std::optional<Place> placeAt(const QPointF& at) const;
  void paintPart(QPainter& painter, std::size_t bar, std::size_t part) const;

  Selection* m_selection;
  std::vector<Bar> m_bars;
  double m_left = 0, m_right = 0;  ///< px beside the bars, for titles and sums
};

}  // namespace geargraph
