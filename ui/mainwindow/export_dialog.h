#pragma once

#include <QDialog>
#include <functional>
#include <utility>
#include <vector>

#include "core/presentation/exporters/exporters.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace geargraph {

/// Asks for a format of all that core exports (allExporters()), and for its options by their types; the file
/// is chosen afterwards. A format that the document has nothing for says why. Not modal.
class ExportDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `live`: the analysis of the document; null while there is none.
  explicit ExportDialog(SnapshotPtr live, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& live);
  /// @pre exporterWithId(id)
  void choose(std::string_view id);
  [[nodiscard]] const Exporter& exporter() const;
  /// The options that differ from what holds without them, and those that choose the format.
  [[nodiscard]] OptionValues options() const;

 signals:
  /// `id` of the exporter.
  void wanted(const QString& id, const geargraph::OptionValues& options);

 private:
  void updateOptions();
  void updateReason();
  QWidget* fieldFor(const ExportOption& option);

  SnapshotPtr m_live;
  QComboBox* m_format;
  QLabel* m_reason;
  QScrollArea* m_scroll;
  QPushButton* m_export;
  /// By option of the format: its name and the values that its field holds; empty: what holds without it.
  std::vector<std::pair<std::string_view, std::function<QString()>>> m_fields;
};

}  // namespace geargraph
