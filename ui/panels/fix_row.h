#pragma once

#include <QWidget>

class QPushButton;

namespace geargraph::inline panels {

/// The buttons that mend a finding, along the lower edge of its row in the list. Whatever is not a button
/// lets the mouse through to the row.
class FixRow : public QWidget {
  Q_OBJECT

 public:
  /// `indent`: where the finding's text begins.
  FixRow(int indent, QWidget* parent);

  QPushButton* addButton(const QString& text);
  /// What the buttons need below the text, in as many lines as they take.
  [[nodiscard]] int heightFor(int width) const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The buttons' places, the first line at y = 0.
  [[nodiscard]] QList<QRect> placesFor(int width) const;

  int m_indent;
  QList<QPushButton*> m_buttons;
};

}  // namespace geargraph::inline panels
