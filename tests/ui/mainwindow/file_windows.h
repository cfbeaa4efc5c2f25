#pragma once

#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_set.h"
#include "ui/theme/application_theme.h"

namespace geargraph::test {

/// Windows of one program on files in a folder that each test has for itself: what tests of opening and of
/// saving are based on.
class FileWindows {
 protected:
  std::unique_ptr<QTemporaryDir> folder;
  std::unique_ptr<WindowSet> set;

  static void setUpWindows() {
    isolateSettings();
    QStandardPaths::setTestModeEnabled(true);
    applyTheme(*qApp, Theme::light);
  }
  void makeFolder() {
    folder = std::make_unique<QTemporaryDir>();
    clearSettings();
    set = std::make_unique<WindowSet>(app());
  }

  [[nodiscard]] QString pathOf(const QString& name) const { return folder->filePath(name); }
  /// The folder of the program's own files.
  [[nodiscard]] QString app() const { return pathOf(QStringLiteral("app")); }
  [[nodiscard]] MainWindow& first() const { return *set->windows().front(); }
  [[nodiscard]] MainWindow& last() const { return *set->windows().back(); }

  static Mechanism withLinks(Mechanism mechanism, int links) {
    for (int i = 0; i < links; ++i) mechanism = withLink(mechanism, {100.0 * (i + 1), 90}).value();
    return mechanism;
  }
  /// The path of a document with this number of links besides the ground.
  QString written(const QString& name, int links) {
    const QString path = pathOf(name);
    if (const auto why = writeDocument(withLinks(emptyMechanism(), links), path))
      qFatal("%s", qPrintable(*why));
    return path;
  }
  static void addLink(MainWindow& window) {
    window.document().apply({QStringLiteral("Add link"),
                             [](const Mechanism& mechanism) {
                               return withLink(mechanism, CanvasPoint{90, 300});
                             },
                             0});
  }

  /// That of the notice in front; null where it has none with this text.
  static QPushButton* buttonOf(MainWindow& window, const QString& text) {
    for (auto* button : window.notices().findChildren<QPushButton*>()) {
      if (!button->isHidden() && button->text() == text) return button;
    }
    return nullptr;
  }
  static void answer(MainWindow& window, const QString& text) {
    QPushButton* button = buttonOf(window, text);
    QVERIFY2(button != nullptr, qPrintable(text));
    QTest::mouseClick(button, Qt::LeftButton);
  }
};

}  // namespace geargraph::test
