#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/teaching/force_tables/force_table.h"

namespace geargraph {

/// What is asked about the torques of a mechanism, one question at a time.
enum class ForceQuestion {
  need,   ///< the torques at motors, brakes and clutches
  flow,   ///< where the power goes, and what is lost
  parts,  ///< the forces on teeth and bearings
  why,    ///< the equations behind them
};

/// A table or a picture that answers a question.
enum class ForceView {
  needs,
  joints,
  couplings,
  states,
  powers,
  losses,
  circulations,
  efficiency,
  meshes,
  bearings,
  why
};

struct QuestionEntry {
  ForceQuestion question;
  QString name;   ///< of its button: "need"
  QString title;  ///< in the language in use
  QString tip;
};

struct ForceViewEntry {
  ForceView view;
  ForceQuestion question;
  std::optional<ForceTableKind> kind;  ///< none: it is no table
  QString name;                        ///< of its button: "joint-torques"
  QString title;                       ///< in the language in use
  QString tip;
};

/// In the order of their buttons.
[[nodiscard]] std::vector<QuestionEntry> questionEntries();
/// All views; those of a question in the order of their buttons, the first is shown first.
[[nodiscard]] std::vector<ForceViewEntry> forceViewEntries();
[[nodiscard]] ForceQuestion questionOf(ForceView view);
[[nodiscard]] std::optional<ForceTableKind> kindOf(ForceView view);

/// Is it a column that the view shows? Forces and losses are of one table, in two answers.
[[nodiscard]] bool showsColumn(ForceView view, int column);

}  // namespace geargraph
