#pragma once

#include <QWidget>

class QPushButton;

namespace geargraph {

/// The quick-fix buttons of a diagnostic, along the lower edge of its row in the list. Outside the buttons
/// mouse events pass through to the row.
class FixRow : public QWidget {
  Q_OBJECT

 public:
  /// @param indent x of the diagnostic's text, in pixels
  FixRow(int indent, QWidget* parent);

  QPushButton* addButton(const QString& text);
  /// The height of the buttons below the text when wrapped into this width, in pixels.
  [[nodiscard]] int heightFor(int width) const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The rectangles of the buttons, with the first line at y = 0.
  [[nodiscard]] QList<QRect> placesFor(int width) const;

  int m_indent;
  QList<QPushButton*> m_buttons;
};

}  // namespace geargraph
