#pragma once

#include "ui/document/document.h"
#include "ui/panels/number_field.h"

namespace geargraph {

/// The efficiency of the meshes that state none, as the document has it. Every change is an undoable edit.
class MeshEfficiencyField : public NumberField {
  Q_OBJECT

 public:
  explicit MeshEfficiencyField(Document* document, QWidget* parent = nullptr);

  /// The definition, for titles and other controls of it.
  [[nodiscard]] static QString meaning();
  /// Sets it in the document, as a part of a gesture.
  static void apply(Document& document, const std::optional<Number>& efficiency, quint64 gesture);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void renew();

  Document* m_document;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
