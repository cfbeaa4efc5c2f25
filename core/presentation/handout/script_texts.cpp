#include "core/presentation/handout/script_texts.h"

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr ScriptText kTexts[] = {
    // page.js
    {"and", toTranslate("and")},
    {"arrowKeys", toTranslate("Arrow keys walk its elements.")},
    {"inputs", toTranslate("Inputs: %1.")},
    {"input", toTranslate("joint %1 at %2 rad/s")},
    {"speed", toTranslate("Speed of joint %1")},
    {"exactSpeed", toTranslate("Speed of joint %1, exact, rad/s")},
    {"numbers", toTranslate("A number such as 2, -3/4 or 0.75.")},
    {"ofJoint", toTranslate("of %1")},
    {"joint", toTranslate("joint")},
    {"nowHead", toTranslate("now, rad/s")},
    {"theme", toTranslate("Light or dark")},
    {"print", toTranslate("Print")},
    {"drawing", toTranslate("Drawing")},
    {"matrix", toTranslate("Matrix")},
    {"reveal", toTranslate("Show what the exercises ask for")},
    {"enlarge", toTranslate("Enlarge: %1")},
    {"smaller", toTranslate("Smaller")},
    {"larger", toTranslate("Larger")},
    {"fit", toTranslate("Fit")},
    {"fitWindow", toTranslate("Fit the window")},
    {"close", toTranslate("Close")},
    // card.js
    {"back", toTranslate("‹ Back")},
    {"next", toTranslate("Next ›")},
    {"endWalk", toTranslate("End")},
    {"walkKeys", toTranslate("Walk round the cycle: left and right arrow keys step, Escape ends")},
    {"walkStep", toTranslate("%1 of %2. %3")},
    {"walkClosed", toTranslate("The walk is closed: row C%1 has no other entries.")},
    {"walk", toTranslate("Walk the cycle")},
    {"selection", toTranslate("Selection")},
    {"clear", toTranslate("Clear the selection")},
    {"now", toTranslate("Now %1 rad/s.")},
    // scene.js
    {"train", toTranslate("The train in three dimensions")},
    {"trainKeys", toTranslate("The train in three dimensions. Arrow keys turn it, plus and minus zoom, Space "
                              "plays, comma and full stop step.")},
    {"play", toTranslate("Play")},
    {"pause", toTranslate("Pause")},
    {"time", toTranslate("Time")},
    {"seconds", toTranslate("%1 s")},
    {"secondsOf", toTranslate("%1 s of %2 s")},
    {"toReference", toTranslate("To the reference pose")},
    {"atLimit", toTranslate("%1 is at its limit of %2°.")},
    {"turnsRound", toTranslate("%1 has reached its limit of %2°: the motion turns round.")},
    {"view3d", toTranslate("3D")},
    {"wholeTrain", toTranslate("Whole train, from the corner")},
    {"alongAxis", toTranslate("Along %1")},
    {"labels", toTranslate("Labels")},
    {"unit", toTranslate("in %1")},
    {"noScene", toTranslate("This browser cannot show the train in three dimensions (%1).")},
    // grader.js, as in core/teaching/grading/grade.cpp
    {"empty", toTranslate("The field %1 is empty.")},
    {"ambiguous",
     toTranslate(
         "“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.")},
    {"notANumber",
     toTranslate("“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.")},
    {"stopsAtNumber",
     toTranslate("“%1” cannot be read from “%2” on: write a whole number, a fraction such as "
                 "−3/4 or a decimal.")},
    {"stopsAtSymbol", toTranslate("“%1” cannot be read from “%2” on: this question knows no such symbol.")},
    {"otherUnit", toTranslate("“%1” has the unit %2: write the number in %3.")},
    {"noUnit", toTranslate("“%1” has the unit %2: write a number without a unit.")},
    {"emptyFields", toTranslate("%1 fields are empty: %2.")},
    {"notAnswered", toTranslate("The question is not answered.")},
    {"notAChoice", toTranslate("“%1” is not among what the question offers for %2.")},
    // exercise.js
    {"cell", toTranslate("Row %1, column %2")},
    {"check", toTranslate("Check")},
    {"tryAgain", toTranslate("Try again")},
    {"show", toTranslate("Show")},
    {"hint", toTranslate("Hint")},
    {"lookAt", toTranslate("Look at %1 in the drawing.")},
    {"fillKeys", toTranslate("Fills the cell and goes on to the next")},
    {"rightOfOne", toTranslate("Right, %1 of 1 point")},
    {"rightOf", toTranslate("Right, %1 of %2 points")},
    {"wrong", toTranslate("Wrong")},
    {"wrongAt", toTranslate("Wrong: %1")},
    {"unreadableAt", toTranslate("Cannot be read: %1")},
    {"otherField", toTranslate("The other field is right.")},
    {"otherFields", toTranslate("The other %1 fields are right.")},
    {"unknownMistake",
     toTranslate("No known mistake explains it. Walk through it once more, or let it be shown.")},
    {"shown", toTranslate("Shown, no points")},
    // exercises.js
    {"drawingOf", toTranslate("%1 of the mechanism")},
    {"scoreOfOne", toTranslate("%1 of 1 point; %2 of %3 checked")},
    {"scoreOf", toTranslate("%1 of %2 points; %3 of %4 checked")},
    {"question", toTranslate("Question %1 of %2")},
    {"questionBefore", toTranslate("Previous question")},
    {"nextQuestion", toTranslate("Next question")},
    {"save", toTranslate("Save answers")},
    {"printQuestions", toTranslate("Print the questions")},
    {"startAgain", toTranslate("Start again")},
    {"startAgainSure", toTranslate("Start again? All answers and the name on this device are deleted.")},
    {"name", toTranslate("Name")},
    {"kept", toTranslate("What you write stays in this browser. Saved answers are a small file to hand in.")},
    {"cannotGrade", toTranslate("This browser cannot grade the answers (%1): write them on paper.")},
    // lesson.js
    {"stepOf", toTranslate("Step %1 of %2")},
    {"stepBefore", toTranslate("Previous step")},
    {"nextStep", toTranslate("Next step")},
    {"hintOf", toTranslate("Hint %1 of %2")},
    {"freshOf", toTranslate("Fresh question %1")},
    {"freshRight", toTranslate("%1 of %2 fresh questions right at the first check")},
    {"lessonScore", toTranslate("%1 of %2 points")},
    {"mastered", toTranslate("You have mastered this lesson.")},
    {"lessonAgainSure", toTranslate("Start again? All answers on this device are deleted.")},
    {"lessonKept", toTranslate("What you write stays in this browser.")},
};

}  // namespace

std::span<const ScriptText> scriptTexts() {
  return kTexts;
}

}  // namespace geargraph
