#pragma once

#include <QWidget>

#include "ui/document/document.h"

namespace geargraph {

/// Shows an editor of this document in a drawing, with the keyboard, which returns to the drawing when the
/// editor is gone. It is cancelled when the document is replaced, which it is not about.
/// @tparam Editor has finish(bool take) and deletes itself
template <class Editor>
void openInPlace(Editor* editor, QWidget* drawing, const Document& document) {
  QObject::connect(&document, &Document::replaced, editor, [editor] { editor->finish(false); });
  QObject::connect(editor, &QObject::destroyed, drawing, [drawing] { drawing->setFocus(); });
  editor->show();
  editor->setFocus();
}

}  // namespace geargraph
