#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/machine/measure/measure.h"

class QColor;
class QPainter;
class QRectF;

namespace geargraph {
class Document;
}  // namespace geargraph

namespace geargraph {

/// What is being measured in a window: up to two spots, named by elements, so that drawings and the 3D view
/// take them for each other, and measure anew after an edit. Everything is measured in the reference pose.
class Measuring final : public QObject {
  Q_OBJECT

 public:
  /// A spot as it was chosen.
  struct Taken {
    ElementId element;  ///< that was pointed at
    std::optional<Vector3> near;
    Spot spot;
  };

  explicit Measuring(Document* document, QObject* parent = nullptr);

  /// Is the tool in use? Switched off, it forgets what was taken.
  [[nodiscard]] bool isOn() const { return m_isOn; }
  void setOn(bool on);

  /// Takes what an element stands for (MeasureSpots::of) as the first or the second spot; a third one begins
  /// anew. False if it has no place; hint() says so. @pre isOn()
  bool take(const ElementId& element, const std::optional<Vector3>& near = {});
  /// Gives the last spot back. False if there was none.
  bool cancel();

  /// The spots of the document as it is. Cost: MeasureSpots, after an edit.
  [[nodiscard]] const MeasureSpots& spots();
  [[nodiscard]] const std::vector<Taken>& taken() const { return m_taken; }
  /// Of the spots that are taken; without values if there are none.
  [[nodiscard]] const Measurement& result() const { return m_result; }
  /// "centre distance 54 mm", one a line.
  [[nodiscard]] const QStringList& lines() const { return m_lines; }
  /// For the clipboard: what was snapped to, then the lines; empty if nothing is measured.
  [[nodiscard]] QString text() const;
  /// What was snapped to and what to do next, for the status bar.
  [[nodiscard]] QString hint() const;

 signals:
  void changed();
  void switched(bool on);

 private:
  void renew();
  void follow();

  Document* m_document;
  DerivedGeometryPtr m_measured;  ///< the spots are its
  std::unique_ptr<MeasureSpots> m_spots;
  bool m_isOn = false;
  bool m_isMissed = false;  ///< what was pointed at last has no place
  std::vector<Taken> m_taken;
  Measurement m_result;
  QStringList m_lines;
};

/// Paints a measured line with rings at its ends and its values on a plate that stays inside `seen`. Pixels.
/// `isDark`: the ground is.
void paintMeasured(QPainter& painter, const std::vector<QPointF>& ends, const QStringList& lines,
                   const QRectF& seen, bool isDark);

}  // namespace geargraph
