#pragma once

#include "ui/panels/property_forms.h"

class QPlainTextEdit;

namespace geargraph {

/// The form for the text of a note. The text is applied while it is typed; everything typed until the field
/// loses the focus is one undo step. For several notes it shows only their number.
class NoteForm : public PropertyForm {
  Q_OBJECT

 public:
  NoteForm(Document* document, std::vector<ElementId> notes);
  void refresh() override;

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();

  QPlainTextEdit* m_text = nullptr;  ///< null for several notes
  bool m_isTaking = false;           ///< what has just been typed, or undone, in the field
};

}  // namespace geargraph
