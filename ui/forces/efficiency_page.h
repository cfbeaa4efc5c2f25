#pragma once

#include "core/teaching/force_tables/efficiency_table.h"
#include "ui/forces/efficiency_plot.h"
#include "ui/service/service.h"
#include "ui/workbench/forces_service.h"

class QComboBox;
class QLabel;
class QStackedWidget;

namespace geargraph {

struct EfficiencyRequest {
  ForcesPtr forces;
  CurveAxis axis = CurveAxis::meshEfficiency;
};
/// The efficiency curve of solved torques.
struct FollowedEfficiency {
  ForcesPtr forces;
  EfficiencyCurve curve;
};
using FollowedEfficiencyPtr = std::shared_ptr<const FollowedEfficiency>;

/// The efficiency of the train as a plot, over the ratio of two speeds or over the efficiency of its meshes;
/// or the torques that hold the loads. Computed on a background thread while the page is visible.
class EfficiencyPage : public QWidget {
  Q_OBJECT

 public:
  explicit EfficiencyPage(QWidget* parent = nullptr);

  /// Shows the newest answer; null: none.
  void show(const ForcesPtr& forces);

  [[nodiscard]] bool isUpToDate() const { return m_curves->isComplete(); }
  /// Null if nothing is plotted.
  [[nodiscard]] const FollowedEfficiencyPtr& followed() const { return m_curves->answer(); }
  [[nodiscard]] EfficiencyPlot& plot() { return *m_plot; }
  /// Why nothing is plotted, as a sentence; empty where something is.
  [[nodiscard]] QString emptyText() const;
  /// std::nullopt if nothing is plotted.
  [[nodiscard]] std::optional<ValueTable> table() const;

 signals:
  void tableChanged();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  using Curves = Service<EfficiencyRequest, FollowedEfficiencyPtr>;

  void updateAxes();
  void ask();
  void showCurve();
  void leaveEmpty(const QString& why);
  [[nodiscard]] EfficiencyPlot::Sheet sheetOf(const FollowedEfficiency& followed) const;

  ForcesPtr m_forces;
  std::optional<CurveAxis> m_wantedAxis;  ///< that was chosen
  Curves* m_curves;
  QWidget* m_choices;  ///< what is plotted, and over what
  QComboBox* m_axis;
  QComboBox* m_quantity;
  QStackedWidget* m_pages;
  EfficiencyPlot* m_plot;
  QLabel* m_empty;
};

}  // namespace geargraph
