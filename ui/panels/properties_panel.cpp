#include "ui/panels/properties_panel.h"

#include "ui/panels/element_forms.h"
#include "ui/workbench/views.h"

namespace geargraph {

PropertiesPanel::PropertiesPanel(Document* document, Selection* selection, QWidget* parent)
    : QScrollArea(parent), m_document(document), m_selection(selection) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(selection, &Selection::selectionChanged, this, &PropertiesPanel::rebuild);
  connect(document, &Document::changed, this, &PropertiesPanel::refresh);
  rebuild();
}

void PropertiesPanel::rebuild() {
  m_form = makePropertyForm(m_document, m_selection->selected());
  m_form->setBackgroundRole(QPalette::Base);
  m_form->setAutoFillBackground(true);
  m_form->refresh();
  connect(m_form, &PropertyForm::elementChosen, m_selection,
          [this](const ElementId& element) { m_selection->select({element}); });
  connect(m_form, &PropertyForm::elementHovered, m_selection,
          [this](const std::optional<ElementId>& element) {
            element ? m_selection->hover(*element) : m_selection->unhover();
          });
  if (QWidget* old = takeWidget()) old->deleteLater();  // the selection may change from inside it
  setWidget(m_form);
}

void PropertiesPanel::refresh() {
  if (m_form->isAboutExisting()) m_form->refresh();
}

ViewEntry propertiesView() {
  return {.id = QStringLiteral("properties"),
          .title = PropertiesPanel::tr("Properties"),
          .purpose = PropertiesPanel::tr("Teeth, axes and names of what is selected."),
          .helpPage = QStringLiteral("teeth-axes-and-3d"),
          .searchWords = QStringLiteral("teeth tooth count module axis name edit value"),
          .place = ViewPlace::right,
          .holdsAnswers = false,
          .servesDrawing = true,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            return new PropertiesPanel(views.document(), views.selection(), parent);
          }};
}

}  // namespace geargraph

#include "moc_properties_panel.cpp"
