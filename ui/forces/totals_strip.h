#pragma once

#include <QString>
#include <vector>

#include "ui/workbench/forces_service.h"

class QLabel;
class QLayout;
class QWidget;

namespace geargraph {

/// The power balance of a train in a few labels: what is fed, taken and lost, the efficiency in both
/// directions, and what circulates.
class TotalsStrip {
 public:
  /// Adds the labels, children of `parent`, to a layout. A value is named "total.fed".
  TotalsStrip(QLayout& layout, QWidget* parent);

  void show(const ForcesPtr& forces);
  void setVisible(bool isVisible);

 private:
  void add(QLayout& layout, QWidget* parent, const char* name, const QString& title, const QString& meaning);
  void set(const char* name, const QString& text, const QString& exact = {});
  void setReal(const char* name, const Real& value);
  void setEfficiency(const char* name, const std::optional<LossySolution>& solution,
                     const std::optional<PowerSums>& sums);

  std::vector<QWidget*> m_pairs;  ///< of a title and a value
  std::vector<QLabel*> m_values;
};

}  // namespace geargraph
