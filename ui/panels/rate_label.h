#pragma once

#include <QWidget>

class QPainter;

namespace geargraph::inline panels {

/// The relative rate of a joint as the paper writes it: θ with a dot above and the joint's label below its
/// right side. Few text fonts place a combining dot on a θ, so it is painted.
///
/// @return the advance in pixels; without a painter nothing is drawn. `at`: where the base line begins.
double paintRate(QPainter* painter, const QFont& font, const QPointF& at, const QString& joint);

/// A rate, and words behind it: "θ̇8 link 4".
class RateLabel : public QWidget {
  Q_OBJECT

 public:
  RateLabel(const QString& joint, const QString& words, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString m_joint;
  QString m_words;
};

}  // namespace geargraph::inline panels
