#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/design/gearboxes/gearbox_wish.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QSpinBox;
class QVBoxLayout;

namespace geargraph::inline files {
class JsonWriter;
}  // namespace geargraph::inline files

namespace geargraph::inline designer {

/// The ratios in a typed or pasted text, as the wish has them: separated by blanks, semicolons, or commas
/// that are no decimal signs; "4,17 2,34" and "4.17, 2.34" are the same two.
[[nodiscard]] QStringList ratiosIn(const QString& text);

/// What a gearbox is wished to do: fields, and what is wrong with them below each.
class WishForm final : public QWidget {
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

 signals:
  void changed();

 private:
  /// Whose fault: a group of fields.
  enum class Field { ratios, reverse, tolerance, sets, layout, elements, k, teeth, efficiency };

  void makeRatios(QVBoxLayout& column);
  void makeSets(QVBoxLayout& column);
  void makeElements(QVBoxLayout& column);
  void makeLimits(QVBoxLayout& column);
  QFormLayout* addForm(QVBoxLayout& column, const QString& heading);
  void addFault(QVBoxLayout& column, Field field);
  QSpinBox* spin(const char* name, int least, int most, int value);
  QLineEdit* line(const char* name, const QString& text);
  void writeWish(JsonWriter& json) const;
  void onEdited();
  void boundLinks();
  void clearFaults();
  void showFault(Field field, const QString& why);
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
  std::array<QSpinBox*, 2> m_brakes;
  std::array<QSpinBox*, 2> m_clutches;
  QCheckBox* m_singleShift;
  std::array<QLineEdit*, 2> m_k;
  QSpinBox* m_fewestTeeth;
  QSpinBox* m_mostRing;
  QLineEdit* m_efficiency;
  QCheckBox* m_buildable;
  std::map<Field, QLabel*> m_faults;
};

}  // namespace geargraph::inline designer
