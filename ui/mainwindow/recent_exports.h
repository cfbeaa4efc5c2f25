#pragma once

#include <QMenu>
#include <QString>
#include <vector>

#include "core/presentation/exporters/exporters.h"

namespace geargraph {

/// An export that can be repeated: of which document, in which format with which options, and where.
struct RecentExport {
  QString document;  ///< its file; empty: it had none
  QString id;        ///< of the exporter
  OptionValues options;
  QString path;
};

/// The last exports, newest first, stored in the settings; and the menu of those of one document.
class RecentExports : public QMenu {
  Q_OBJECT

 public:
  static constexpr std::size_t kMax = 20;   ///< kept of all documents
  static constexpr std::size_t kShown = 8;  ///< listed of one

  explicit RecentExports(QWidget* parent = nullptr);

  /// Replaces an older one to the same place.
  static void add(const RecentExport& made);
  /// Those whose format there is; of any document if `document` is null.
  [[nodiscard]] static std::vector<RecentExport> all(const QString* document = nullptr);

  /// The document of the window, whose exports are listed from now on.
  void setDocument(const QString& file);

 signals:
  void chosen(const geargraph::RecentExport& again);

 private:
  void fill();

  QString m_document;
};

}  // namespace geargraph
