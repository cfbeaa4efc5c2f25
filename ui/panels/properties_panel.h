#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

namespace geargraph {

class PropertyForm;

/// The editable properties of the selected elements; of the document if nothing is selected.
class PropertiesPanel : public QScrollArea, public ResultsView {
  Q_OBJECT

 public:
  PropertiesPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }

 private:
  void rebuild();
  void refresh();

  Document* m_document;
  Selection* m_selection;
  PropertyForm* m_form = nullptr;
};

[[nodiscard]] ViewEntry propertiesView();

}  // namespace geargraph
