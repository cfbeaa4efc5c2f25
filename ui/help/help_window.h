#pragma once

#include <QDialog>
#include <vector>

class QLabel;
class QLineEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace geargraph {

class HelpBrowser;

/// The manual in a window of its own beside the document: contents, pages, back and forward, and a search
/// field for all pages.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent);

  /// Opens "page", "page#anchor" or "#anchor" in the current page. False if there is no such page.
  bool open(const QString& pageAndAnchor);
  /// "page#anchor" as it was opened last.
  [[nodiscard]] const QString& place() const { return m_places[m_at]; }
  [[nodiscard]] HelpBrowser& browser() { return *m_browser; }

 signals:
  void commandWanted(const QString& menuPath);
  void lessonWanted(const QString& id);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeBar();
  QToolButton* makeButton(const char* name, const QString& text, const QString& tip);
  void fillContents();
  void display(const QString& place);
  void go(int steps);
  void findNext();
  void updateButtons();

  HelpBrowser* m_browser;
  QTreeWidget* m_contents;
  QLineEdit* m_find;
  QLabel* m_found;
  QToolButton* m_back = nullptr;
  QToolButton* m_forward = nullptr;
  std::vector<QString> m_places;  ///< history of shown places, the newest last
  std::size_t m_at = 0;
};

}  // namespace geargraph
