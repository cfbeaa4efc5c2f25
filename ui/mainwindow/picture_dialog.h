#pragma once

#include <QDialog>

#include "core/picture/picture.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace geargraph {

/// A picture that somebody wants: of which view, and how.
struct PictureWish {
  QString view;  ///< a drawing's name, or "3d"
  DrawingPicture picture;
};

/// Asks what picture to export; the file is asked for afterwards. It does not lock the window.
class PictureDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `views`: names and titles, the one in front first to be chosen. "3d" is pixels only.
  PictureDialog(const std::vector<std::pair<QString, QString>>& views, const QString& inFront, bool dark,
                QWidget* parent = nullptr);

  [[nodiscard]] PictureWish wish() const;

 signals:
  void wanted(const geargraph::PictureWish& wish);

 private:
  void renew();

  QComboBox* m_view;
  QComboBox* m_form;
  QCheckBox* m_sized;
  QSpinBox* m_width;
  QSpinBox* m_height;
  QCheckBox* m_transparent;
  QCheckBox* m_dark;
};

}  // namespace geargraph
