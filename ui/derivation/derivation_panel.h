#pragma once

#include <QWidget>

#include "ui/derivation/derivation_view.h"

class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace geargraph::inline ui_derivation {

/// The derivation of the newest snapshot: a list of its sections, and the derivation as on a page. It is
/// worked out only while it is in sight.
class DerivationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DerivationPanel(Selection* selection, QWidget* parent = nullptr);

  /// `whyNot`: what keeps this mechanism from being derived; empty for nothing.
  void setSnapshot(const SnapshotPtr& snapshot, const QString& whyNot);
  /// Is it in sight?
  void setAwake(bool awake);
  /// Brings the section with this heading into sight, once the derivation is there; the beginning where it
  /// has none.
  void showSection(const QString& heading);
  /// Is the derivation that is shown the newest snapshot's?
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_snapshot; }

  [[nodiscard]] DerivationView& view() { return *m_view; }
  [[nodiscard]] QComboBox& sections() { return *m_sections; }
  /// What stands in its place; empty while a derivation is shown.
  [[nodiscard]] QString emptyText() const;

 signals:
  void exportWanted();
  void reportShown();

 private:
  QWidget* makeBar();
  void renew();
  void showReport(const SetReportPtr& report);
  void showText(const QString& text);
  void showWantedSection();
  void fillSections();

  DerivationService* m_service;
  DerivationView* m_view;
  QStackedWidget* m_pages = nullptr;
  QLabel* m_empty = nullptr;
  QComboBox* m_sections = nullptr;
  QToolButton* m_export = nullptr;
  SnapshotPtr m_snapshot;
  SnapshotPtr m_wanted;  ///< asked for last
  SnapshotPtr m_shown;
  QString m_whyNot;
  QString m_section;  ///< the heading that is to come into sight with the next report
  bool m_isAwake = false;
};

}  // namespace geargraph::inline ui_derivation
