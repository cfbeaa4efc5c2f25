#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/views/results_view.h"
#include "ui/views/view_entry.h"

namespace geargraph::inline panels {

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

}  // namespace geargraph::inline panels
