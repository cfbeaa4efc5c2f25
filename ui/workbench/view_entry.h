#pragma once

#include <QSize>
#include <QString>

class QWidget;

namespace geargraph {

class ResultsView;
class Views;

/// Where a view is shown until the user moves it. Views of one place share it as tabs, in the order of their
/// table.
enum class ViewPlace {
  drawings,  ///< a tab in the middle of the window; not moved
  bottom,
  top,    ///< at the right, above `right`
  right,  ///< at the right
  left,   ///< nothing but lessons
};

/// What the surfaces of the program have to know of a view before and after it is made. Its panel, its entry
/// in the menu and in the search, its page of the manual, its part in lessons and presentations follow from
/// it. Texts are in the language in use.
struct ViewEntry {
  /// "gearbox". Saved layouts know its panel as "dock.gearbox": never changed, never translated.
  QString id = {};
  QString title = {};
  QString tip = {};          ///< of its tab among the drawings
  QString purpose = {};      ///< one sentence, for "What's this"
  QString helpPage = {};     ///< "page" or "page#anchor" of the manual
  QString searchWords = {};  ///< by which the search finds it besides its title, in English
  ViewPlace place = ViewPlace::bottom;
  QSize minimumSize = {};      ///< px; invalid: minimumSizeHint() of its widget
  bool holdsAnswers = true;    ///< closed in a lesson until the step is right or shown
  bool servesDrawing = false;  ///< shown while a lesson has something drawn
  bool isPresented = false;    ///< shown in the first presentation
  bool wantsRoom = false;      ///< of a tab: the panels round the drawings are put away while it is in front
  /// Makes the view and connects it with what it needs: services of views.workbench(), views that come before
  /// it in the table, signals of `views`.
  ResultsView* (*make)(Views& views, QWidget* parent) = nullptr;
};

}  // namespace geargraph
