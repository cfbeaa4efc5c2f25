#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/document/document.h"
#include "ui/selection/selection.h"

namespace geargraph::inline panels {

class PropertyForm;

/// The editable properties of the selected elements; of the document if nothing is selected.
class PropertiesPanel : public QScrollArea {
  Q_OBJECT

 public:
  PropertiesPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

 private:
  void rebuild();
  void refresh();

  Document* m_document;
  Selection* m_selection;
  PropertyForm* m_form = nullptr;
};

}  // namespace geargraph::inline panels
