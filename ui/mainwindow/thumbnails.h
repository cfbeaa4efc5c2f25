#pragma once

#include <QImage>
#include <QObject>
#include <QSize>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph::inline mainwindow {

/// Small pictures of documents for lists. Those of examples are drawn when they are asked for, those of files
/// when the file is opened or saved, and kept in the cache folder, so that showing a list reads no document.
/// All drawing is done by the thread pool.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  static constexpr QSize kSize{208, 130};  ///< pixels of a screen with 96 dots per inch

  explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

  /// Draws the pictures of a file, for both themes, and keeps them.
  static void keep(const QString& filePath, const MechanismPtr& mechanism);
  /// The picture that was kept, twice as fine as kSize; null where there is none.
  [[nodiscard]] static QImage kept(const QString& filePath, Theme theme);
  /// Where it is kept, for the `img` of a tool tip.
  [[nodiscard]] static QString keptPath(const QString& filePath, Theme theme);

  /// Answers with drawn(), soon and in any order.
  void draw(const QString& path, Theme theme);

 signals:
  void drawn(const QString& path, geargraph::Theme theme, const QImage& picture);
};

}  // namespace geargraph::inline mainwindow
