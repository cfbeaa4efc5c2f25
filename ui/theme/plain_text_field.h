#pragma once

#include <QPlainTextEdit>

namespace geargraph {

/// A field for some lines of text that cannot be dragged with the mouse: a drag runs an event loop inside the
/// field's own mouse event, in which an edit or the loss of the focus may delete the field. Pressing on
/// selected text begins a new selection.
class PlainTextField : public QPlainTextEdit {
  Q_OBJECT

 public:
  using QPlainTextEdit::QPlainTextEdit;

 protected:
  void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace geargraph
