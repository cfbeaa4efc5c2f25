#pragma once

#include <QWidget>

#include "ui/reading/derivation_view.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace geargraph {

/// The derivation of the newest snapshot: a list of its sections, and the derivation as a page. Computed only
/// while the panel is visible.
class DerivationPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit DerivationPanel(Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  /// `whyNot`: why there is no derivation of this mechanism; empty if there is one.
  void setSnapshot(const SnapshotPtr& snapshot, const QString& whyNot);
  void setAwake(bool awake) override;
  /// Scrolls to the section with this heading as soon as the derivation is available; to the beginning if
  /// there is no such section.
  void showSection(const QString& heading);
  /// Is the shown derivation that of the newest snapshot?
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_snapshot; }

  [[nodiscard]] DerivationView& view() { return *m_view; }
  [[nodiscard]] QComboBox& sections() { return *m_sections; }
  [[nodiscard]] QString emptyText() const override;

 signals:
  void exportWanted();
  void handoutWanted();
  void reportShown();

 private:
  QWidget* makeBar();
  void renew();
  void showDerivation(const Derivation& derivation);
  void showText(const QString& text);
  void showWantedSection();
  void fillSections();

  DerivationService* m_service;
  DerivationView* m_view;
  QStackedWidget* m_pages = nullptr;
  QLabel* m_empty = nullptr;
  QComboBox* m_sections = nullptr;
  QToolButton* m_handout = nullptr;
  QToolButton* m_export = nullptr;
  SnapshotPtr m_snapshot;
  SnapshotPtr m_wanted;  ///< last requested
  SnapshotPtr m_shown;
  QString m_whyNot;
  QString m_section;  ///< the heading to scroll to with the next report
  bool m_isAwake = false;
};

/// Why there is no derivation of a mechanism, as a sentence; empty if there is one.
[[nodiscard]] QString whyNoDerivation(const Mechanism& mechanism);

[[nodiscard]] ViewEntry derivationView();

}  // namespace geargraph
