#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/document/document.h"
#include "ui/selection/selection.h"

namespace geargraph::inline panels {

class PropertyForm;

/// What can be said about the selected elements, edited live. Nothing selected: the document itself.
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
