#pragma once

#include <QWidget>

#include "ui/document/selection.h"
#include "ui/motion_panel/vibration_service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class DrawingPreview;
class LinkedTable;
class NumberField;
class ValueTableModel;

enum class VibrationView { frequencies, spectrum, lostMotion };

/// For the person with the accelerometer and the dial gauge: frequencies of shafts, meshes and planets as a
/// table and as the lines of a spectrum, and how far the outputs turn while the inputs are held. Nothing is
/// computed while the panel is hidden.
class VibrationPanel final : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit VibrationPanel(Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  [[nodiscard]] bool isSettled() const override { return m_service->isComplete(); }
  [[nodiscard]] QString emptyText() const override;

  void showView(VibrationView view);
  [[nodiscard]] VibrationView view() const;
  /// The table in sight; null where there is none.
  [[nodiscard]] std::shared_ptr<const ValueTable> table() const;

 signals:
  void settled();
  /// The table as CSV, under a name for its file.
  void exportWanted(const QString& name, const QString& csv);

 private:
  [[nodiscard]] QWidget* makeChips();
  [[nodiscard]] QWidget* makeFields();
  [[nodiscard]] NumberField* wholeField(const char* name, const QString& title, int value, int least,
                                        int most);
  void ask();
  void showAnswer(const VibrationPtr& answer);
  void showCases(const VibrationAnswer& answer);
  void showEmpty(const QString& why);
  [[nodiscard]] int chosenCase(const VibrationAnswer& answer) const;
  [[nodiscard]] QString csv(char separator) const;

  VibrationService* m_service;
  SnapshotPtr m_snapshot;
  bool m_isAwake = false;
  QButtonGroup* m_chips = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_export = nullptr;
  QWidget* m_fields = nullptr;
  QLabel* m_stateName = nullptr;
  QComboBox* m_states = nullptr;
  NumberField* m_rpm = nullptr;
  NumberField* m_harmonics = nullptr;
  NumberField* m_sidebands = nullptr;
  NumberField* m_planets = nullptr;
  QLabel* m_reference;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  ValueTableModel* m_model;
  LinkedTable* m_table;
  DrawingPreview* m_spectrum;
};

[[nodiscard]] ViewEntry vibrationView();

}  // namespace geargraph
