#pragma once

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// `exercises kinds FILE`: lists the kinds of question about a mechanism, and why the others are not
/// available.
int listExerciseKinds(const Arguments& arguments);

/// `exercises make FILE [--kinds LIST] [--seed N] [--variants N | --names FILE] [--title TEXT] [--to LIST]
/// [--force] -o FOLDER`: writes the sheet (sheet.json), and for each variant its questions and solution in
/// every format and a file for the answers.
int makeExercises(const Arguments& arguments);

/// `exercises grade SHEET ANSWERS... [-o CSV] [--summary OUT]`: writes points and reasons, one line per
/// question and one for the sum, and the mistakes of the class. ANSWERS are files, or folders of files.
int gradeExercises(const Arguments& arguments);

/// Reports that the mechanism has too many links; returns the exit status.
int tooLargeForExercises();

}  // namespace geargraph::cli
