#pragma once

#include "ui/panels/property_forms.h"

class QPlainTextEdit;

namespace geargraph::inline panels {

/// The text of a note, applied as it is typed; what is typed until the field is left is one undo step. For
/// several notes: how many there are.
class NoteForm : public PropertyForm {
  Q_OBJECT

 public:
  NoteForm(Document* document, std::vector<ElementId> notes);
  void refresh() override;

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();

  QPlainTextEdit* m_text = nullptr;  ///< of one note
};

}  // namespace geargraph::inline panels
