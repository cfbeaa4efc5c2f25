#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <set>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph::inline document {
class Document;
}  // namespace geargraph::inline document
namespace geargraph::inline selection {
class Selection;
}  // namespace geargraph::inline selection
namespace geargraph::inline workbench {
class Workbench;
}  // namespace geargraph::inline workbench

namespace geargraph::inline mainwindow {

class PictureClipboard;

/// Commands that edit what is selected, whatever view shows it. The clipboard holds a document in JSON, which
/// reaches other windows, other programs and text editors, and beside it the picture of what was copied.
class EditCommands : public QObject {
  Q_OBJECT

 public:
  /// `picture`: the drawing in front as it is exported.
  EditCommands(Workbench& workbench, PictureClipboard* clipboard, std::function<DisplayList()> picture,
               QWidget* window);

  bool copy();  ///< false if nothing selected can be copied
  void cut();
  void paste();
  void duplicate();
  /// Of the first selected link: it becomes the ground; it gets equally spaced twins, `total` planets in all.
  void makeGround();
  void makePlanets(int total);
  void insertSet(const Mechanism& set);

 signals:
  void refused(const QString& why);
  void noted(const QString& note);

 private:
  void insert(const Mechanism& fragment, const QString& text);
  void inserted(const std::set<ElementId>& added, const std::string& unit);

  QWidget* m_window;
  Document* m_document;
  Selection* m_selection;
  PictureClipboard* m_clipboard;
  std::function<DisplayList()> m_picture;
};

}  // namespace geargraph::inline mainwindow
