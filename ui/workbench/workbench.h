#pragma once

#include "ui/analysis/analysis_service.h"
#include "ui/document/document.h"
#include "ui/motion/motion_check_service.h"
#include "ui/selection/selection.h"
#include "ui/stage/stage_service.h"
#include "ui/statics/forces_service.h"

namespace geargraph::inline workbench {

/// What the views of a window share: the document, what is selected in it, and the services that follow it.
/// An edit goes to the document, the document to the analysis, each snapshot to the stage, to the statics
/// and, once it is complete, to the motion check; their answers go to the views.
class Workbench final : public QObject {
  Q_OBJECT

 public:
  explicit Workbench(QObject* parent = nullptr);
  /// Goes on with the document and the selection of a window that is built anew, history and all; what
  /// follows from the document is worked out again. The former one follows it no longer, and must go before
  /// this one.
  Workbench(Workbench& former, QObject* parent);
  ~Workbench() override;

  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() { return *m_selection; }
  [[nodiscard]] AnalysisService& analysis() { return *m_analysis; }
  [[nodiscard]] StageService& stages() { return *m_stages; }
  [[nodiscard]] ForcesService& forces() { return *m_forces; }
  [[nodiscard]] MotionCheckService& motionCheck() { return *m_motionCheck; }

  /// Requests what belongs to the document as it is now; every change of the document does so by itself.
  void request();
  /// Has all of it been answered?
  [[nodiscard]] bool isUpToDate() const;

 private:
  Workbench(Document* document, Selection* selection, QObject* parent);

  Document* m_document;
  Selection* m_selection;
  AnalysisService* m_analysis;
  StageService* m_stages;
  ForcesService* m_forces;
  MotionCheckService* m_motionCheck;
};

}  // namespace geargraph::inline workbench
