#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/design/gearboxes/gearbox_wish.h"
#include "ui/designer/field_form.h"

class QCheckBox;
class QComboBox;

namespace geargraph {

/// What a gearbox is wished to do: fields, and what is wrong with them below each.
class WishForm final : public FieldForm {
  Q_OBJECT

 public:
  explicit WishForm(QWidget* parent = nullptr);

  /// The wish as `geargraph-cli gearbox` reads it (resources/schema/README.md).
  [[nodiscard]] std::string json() const;
  /// Reads it; faults are shown at their fields, the first of which gets the focus. std::nullopt if there are
  /// any.
  [[nodiscard]] std::optional<GearboxWish> wish();
  /// Fills in the example of the empty list.
  void setExample();
  static constexpr const char* kExampleRatios = "4.17 2.34 1.52 1.14 0.87 0.69";

 protected:
  void onEdited() override;

 private:
  /// Groups of fields, which have faults together.
  enum class Field { ratios, reverse, tolerance, sets, layout, elements, k, teeth, efficiency };

  void makeRatios(QVBoxLayout& column);
  void makeSets(QVBoxLayout& column);
  void makeElements(QVBoxLayout& column);
  void makeLimits(QVBoxLayout& column);
  void writeWish(JsonWriter& json) const;
  void addFault(QVBoxLayout& column, Field field) { FieldForm::addFault(column, static_cast<int>(field)); }
  void showFault(Field field, const QString& why) { FieldForm::showFault(static_cast<int>(field), why); }
  void boundLinks();
  [[nodiscard]] static std::optional<Field> fieldAt(const std::string& pointer);
  [[nodiscard]] QWidget* widgetOf(Field field) const;
  [[nodiscard]] int basicSetCount() const;

  QPlainTextEdit* m_ratios;
  QComboBox* m_reverse;
  QLineEdit* m_reverseRatio;
  QLineEdit* m_tolerance;
  std::array<QSpinBox*, 3> m_sets;  ///< by SetKind
  QSpinBox* m_links;
  QSpinBox* m_held;
  QCheckBox* m_freeInput;
  QSpinBox* m_elements;
  Numbers m_brakes;
  Numbers m_clutches;
  QCheckBox* m_singleShift;
  std::array<QLineEdit*, 2> m_k;
  QSpinBox* m_fewestTeeth;
  QSpinBox* m_mostRing;
  QLineEdit* m_efficiency;
  QCheckBox* m_buildable;
};

}  // namespace geargraph
