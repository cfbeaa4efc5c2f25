#pragma once

#include "ui/canvas/drawing_view.h"
#include "ui/schematic/schematic_service.h"

namespace geargraph {

/// The functional schematic of the document [AU, Figs. 1 and 3]. The program lays it out, on a thread of its
/// own, whenever the document changes; until then the last drawing stands.
class SchematicView : public DrawingView {
  Q_OBJECT

 public:
  SchematicView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Is the document as it is now drawn?
  [[nodiscard]] bool isUpToDate() const { return m_service->isUpToDate(); }

 signals:
  /// The document as it is now is drawn.
  void drawn();

 protected:
  void rebuild() override;
  void forgetDocument() override { m_fitNext = true; }
  [[nodiscard]] QString message() const override;
  void adjustMenu(ContextActions& actions, SheetPoint at) override;
  /// An axis has its places among the properties of its joints.
  void openElement(const ElementId& element) override;

 private:
  void showDrawing(const SchematicPtr& schematic);

  SchematicService* m_service;
  DrawingScene* m_sheet;
  SchematicPtr m_schematic;
  bool m_fitNext = true;  ///< the next drawing is another document's
};

}  // namespace geargraph
