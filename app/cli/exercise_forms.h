#pragma once

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// `exercises kinds FILE`: what can be asked about a mechanism, and why the rest cannot.
int listExerciseKinds(const Arguments& arguments);

/// `exercises make FILE [--kinds LIST] [--seed N] [--variants N | --names FILE] [--title TEXT] [--to LIST]
/// [--force] -o FOLDER`: the sheet (sheet.json), and for each variant its questions and its solution in every
/// form and a file for the answers.
int makeExercises(const Arguments& arguments);

/// `exercises grade SHEET ANSWERS... [-o CSV]`: points and reasons, a line a question and one for the sum.
/// ANSWERS are files and folders of files.
int gradeExercises(const Arguments& arguments);

/// Reports a mechanism of too many links; the exit status.
int tooLargeForExercises();

}  // namespace geargraph::cli
