#pragma once

#include <optional>

#include "core/design/gearboxes/hub_wish.h"
#include "ui/designer/field_form.h"

class QCheckBox;

namespace geargraph {

/// What a maker's sheet says of a hub gear, and what has been counted in it.
class HubForm final : public FieldForm {
  Q_OBJECT

 public:
  explicit HubForm(QWidget* parent = nullptr);

  /// The wish as `geargraph-cli hardware` reads it (resources/schema/README.md).
  [[nodiscard]] std::string json() const;
  /// Reads it; faults are shown at their fields, the first of which gets the focus. std::nullopt if there are
  /// any.
  [[nodiscard]] std::optional<HubWish> wish();
  void setExample();
  static constexpr const char* kExampleRatios = "0.632 0.741 0.843 0.989 1.145 1.335 1.545";

 private:
  enum class Field { ratios, structure, limits, counted };

  void makeSheet(QVBoxLayout& column);
  void makeLimits(QVBoxLayout& column);
  void makeCounted(QVBoxLayout& column);
  [[nodiscard]] static Field fieldAt(const std::string& pointer);

  QPlainTextEdit* m_ratios = nullptr;
  QSpinBox* m_direct = nullptr;
  QLineEdit* m_tolerance = nullptr;
  QSpinBox* m_sets = nullptr;
  QCheckBox* m_stepped = nullptr;
  Numbers m_planets{};
  Numbers m_suns{};
  Numbers m_rings{};
  QSpinBox* m_slack = nullptr;
  QLineEdit* m_counted = nullptr;
};

}  // namespace geargraph
