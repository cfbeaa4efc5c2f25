#pragma once

#include <QWidget>

#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

namespace geargraph {
class InputsPanel;
class ResultsPanel;
}  // namespace geargraph

namespace geargraph {

/// The speeds of the motors, the torques of a document with loads, and how fast everything turns with them.
class InputsAndResults final : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  InputsAndResults(Views& views, QWidget* parent);

  [[nodiscard]] ResultsPanel& results() { return *m_results; }

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setMechanism(const MechanismPtr& mechanism) override;
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  [[nodiscard]] QString emptyText() const override;

 private:
  InputsPanel* m_inputs;
  ResultsPanel* m_results;
};

[[nodiscard]] ViewEntry inputsView();

}  // namespace geargraph
