#include <array>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/words.h"
#include "core/teaching/exercises/exercise_kinds.h"

namespace geargraph::inline exercises {
namespace {

struct Hint {
  ExerciseKind kind;
  std::string_view text;
};

constexpr std::array kHints = {
    Hint{ExerciseKind::incidence,
         toTranslate(
             "Take one column at a time. Its arrow touches two links only: the one that it leaves gets "
             "−1, the one that it points to gets 1.")},
    Hint{
        ExerciseKind::orientation,
        toTranslate("Read the matrix, not the drawing, one column at a time: the arrow leaves the link whose "
                    "entry is −1 and points to the link whose entry is 1.")},
    Hint{ExerciseKind::reducedIncidence,
         toTranslate("All speeds are measured against one link: Γ leaves out its row. The other rows are "
                     "those of Γ⁰.")},
    Hint{ExerciseKind::path,
         toTranslate("Start at the link of the column and walk to the ground along turning joints only. Then "
                     "compare the arrow of each joint on the walk with your direction.")},
    Hint{ExerciseKind::treeMatrix,
         toTranslate(
             "Keep the turning joints and only the mesh of the row: together they close one cycle. Begin "
             "along the mesh, from tail to head, and compare each arrow on the way back with your "
             "direction.")},
    Hint{ExerciseKind::cycle,
         toTranslate("From both links of the mesh, walk along turning joints toward the ground until the two "
                     "walks meet. What they share from there on is not part of the cycle.")},
    Hint{ExerciseKind::cycleSense,
         toTranslate(
             "Choose a link of the cycle and go once round without turning back. Only the direction of "
             "each arrow against your own counts.")},
    Hint{ExerciseKind::cycleBasis,
         toTranslate(
             "Begin with the columns of the meshes: a cycle of the basis holds one mesh, its own. Then "
             "walk from the head of the mesh back to its tail along turning joints.")},
    Hint{ExerciseKind::anyCycles,
         toTranslate(
             "Each mesh closes one cycle with the turning joints. Go round one after the other; within a "
             "row all signs belong to the same walk.")},
    Hint{ExerciseKind::spanningTree,
         toTranslate("The turning joints are a spanning tree already. With the mesh they close a loop: which "
                     "edges of this loop could go?")},
    Hint{ExerciseKind::wrongEntry,
         toTranslate(
             "Derive the matrix from the drawing, row by row, and stop at the first entry that differs. "
             "Compare signs with the directions of the arrows.")},
    Hint{
        ExerciseKind::coefficients,
        toTranslate("Start from the cycle of the mesh: only its joints have entries. The size of an entry is "
                    "the number of teeth of the gear on whose axis the joint turns.")},
    Hint{ExerciseKind::freedom,
         toTranslate(
             "Each mesh gives one equation. Count those that do not follow from the others, and subtract "
             "their number from that of the turning joints.")},
    Hint{ExerciseKind::redundantMesh,
         toTranslate(
             "Look for meshes that tie the same links together in two ways. Leave one out: if the others "
             "still force the same speeds, it is redundant.")},
    Hint{ExerciseKind::inputs,
         toTranslate(
             "Take as many joints as there are degrees of freedom. Imagine all of them locked: nothing "
             "else may move, and no mesh may tie two of them to each other.")},
    Hint{ExerciseKind::speed,
         toTranslate("Look for a mesh whose equation has one unknown speed only, solve it, and go on to the "
                     "next. A row of P θ̇ = 0 holds the joints of one cycle.")},
    Hint{ExerciseKind::levels,
         toTranslate(
             "The level of a joint is the letter of its axis. Name the axis of each joint on the walk: "
             "where the letter changes is the transfer vertex.")},
    Hint{
        ExerciseKind::terminalEquation,
        toTranslate("The carrier is the link where the level changes on the way between both gears. The gear "
                    "with fewer teeth turns faster; for the sign, look at each gear along its own axis.")},
    Hint{ExerciseKind::fundamentalCircuit,
         toTranslate(
             "Walk from the carrier to the gear along turning joints: only these joints count. Compare "
             "their arrows with your direction.")},
    Hint{
        ExerciseKind::cutset,
        toTranslate("Without the joint the turning joints fall into two groups of links. Look for edges with "
                    "one end in each group, and compare their direction with that of the joint.")},
    Hint{ExerciseKind::portTorque,
         toTranslate(
             "Write the power of each port, torque times speed. Their sum is zero if no power is lost; "
             "then put in the terminal equation.")},
    Hint{ExerciseKind::teeth,
         toTranslate(
             "Reduce the fraction. Then multiply both of its parts by the same whole number until both "
             "are within the bounds.")},
    Hint{ExerciseKind::ringTeeth,
         toTranslate(
             "The centre distance goes with the sum of the teeth where both gears are external, and with "
             "their difference where one is a ring.")},
    Hint{ExerciseKind::engagement,
         toTranslate("Each engaged element takes degrees of freedom away until one is left. An engaged brake "
                     "makes the speed of its link zero: try which set gives the ratio.")},
    Hint{
        ExerciseKind::brakeTorque,
        toTranslate(
            "The torques of all shafts and brakes of the train add up to zero, and so do their powers. Write "
            "both sums for what is engaged, then compare the sizes.")},
    Hint{ExerciseKind::selfLocking,
         toTranslate("Let the load drive: behind each mesh less power arrives, by its efficiency. If none "
                     "would be left at the input, or it would have to be driven, the train locks.")},
    Hint{
        ExerciseKind::brakeReaction,
        toTranslate("The torques of drive, load and brake on the train add up to zero, and a brake passes no "
                    "power. What acts on a link acts on the other part in the opposite sense.")},
};

}  // namespace

std::string kindHint(ExerciseKind kind) {
  const Hint& hint = kHints[static_cast<std::size_t>(kind)];
  GEARGRAPH_REQUIRE(hint.kind == kind);
  return translated(hint.text);
}

}  // namespace geargraph::inline exercises
