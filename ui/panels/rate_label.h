#pragma once

#include <QWidget>

class QPainter;

namespace geargraph {

/// Paints the relative rate of a joint in the paper's notation: θ with a dot above and the joint's label as a
/// subscript. The dot is painted separately because few fonts place a combining dot on a θ well.
///
/// @param painter null: only measures
/// @param at the start of the baseline
/// @return the advance in pixels
double paintRate(QPainter* painter, const QFont& font, const QPointF& at, const QString& joint);

/// A rate followed by text: "θ̇8 link 4". The text is cut off with an ellipsis where there is less room.
class RateLabel : public QWidget {
  Q_OBJECT

 public:
  explicit RateLabel(QWidget* parent = nullptr);

  void setRate(const QString& joint, const QString& words);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QSize withWords(double width) const;

  QString m_joint;
  QString m_words;
};

}  // namespace geargraph
