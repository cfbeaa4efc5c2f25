#pragma once

#include <QWidget>

#include "ui/reading/formula_painter.h"

namespace geargraph {

/// A label with one displayed formula at its natural width: put it into a scroll area if it may be long.
class FormulaLabel : public QWidget {
  Q_OBJECT

 public:
  explicit FormulaLabel(QWidget* parent = nullptr);

  /// Sets the formula, in core's subset of TeX. @pre it can be parsed (typeset/tex_reader.h), or is empty
  void setTex(const std::string& tex);
  [[nodiscard]] const std::string& tex() const { return m_tex; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] double em() const;

  std::string m_tex;
  FormulaBox m_box;
  FormulaPainter m_painter;
};

}  // namespace geargraph
