#pragma once

#include <QFrame>

#include "core/theory/statics/locking_limits.h"
#include "ui/document/document.h"
#include "ui/service/service.h"
#include "ui/workbench/forces_service.h"

class QLabel;
class QSlider;

namespace geargraph {
class MeshEfficiencyField;
}  // namespace geargraph

namespace geargraph {

/// Results that take longer than the torques themselves.
struct EfficiencyAnswer {
  ForcesPtr forces;
  std::string formula;                  ///< as RationalFunction::toText(); empty: none within the budget
  std::optional<LockingLimits> limits;  ///< none if efficiencies have no curve
};
using EfficiencyAnswerPtr = std::shared_ptr<const EfficiencyAnswer>;

/// The efficiency of the train: forward and backward, in symbols, and where self-locking begins; with a
/// slider (a drag is one undo step) and a field for the efficiency of the document's meshes.
class EfficiencyCard : public QFrame {
  Q_OBJECT

 public:
  explicit EfficiencyCard(Document* document, QWidget* parent = nullptr);

  /// Shows the newest answer; null: none.
  void show(const ForcesPtr& forces);
  [[nodiscard]] bool isUpToDate() const { return m_answers->isComplete(); }
  [[nodiscard]] QString formula() const;
  [[nodiscard]] QString locking() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  using Answers = Service<ForcesPtr, EfficiencyAnswerPtr>;

  void makeMover();
  void makeValue(const char* name, const QString& title, const QString& meaning);
  void showStated();
  [[nodiscard]] QString ownLosses() const;
  void showValues();
  void showValue(const char* name, const std::optional<LossySolution>& solution,
                 const std::optional<PowerSums>& sums);
  void showAnswer();
  void ask();

  Document* m_document;
  ForcesPtr m_forces;
  Answers* m_answers;
  QSlider* m_slider;
  MeshEfficiencyField* m_field;
  QLabel* m_own;  ///< what meshes state themselves
  QLabel* m_locking;
  QLabel* m_formula;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
