#include "core/teaching/derivation/glossary.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

const std::vector<Definition>& glossary() {
  static const std::vector<Definition> definitions = {
      {Term::movingLinks, "n", toTranslate("Moving links"),
       toTranslate("The number of links without the ground. They bear the labels 1 to n; the ground is 0."),
       PaperEquation::none},
      {Term::turningJoints, "t", toTranslate("Turning joints"),
       toTranslate("The number of turning pairs. They bear the labels n+1 to n+t. As a spanning tree they "
                   "are as many as the moving links."),
       PaperEquation::none},
      {Term::gearMeshes, "c", toTranslate("Gear meshes"),
       toTranslate("The number of gear pairs. They bear the labels n+t+1 to n+t+c. Each closes one cycle of "
                   "the basis."),
       PaperEquation::none},
      {Term::rank, "rank", toTranslate("Rank"),
       toTranslate("The number of independent equations that the meshes put on the turning joints: the rank "
                   "r of the coefficient matrix P."),
       PaperEquation::coefficientMatrix},
      {Term::degreesOfFreedom, "DOF", toTranslate("Degrees of freedom"),
       toTranslate("How many joints have to be driven so that the motion of all others follows: E = t − r."),
       PaperEquation::freedom},
      {Term::incidenceMatrix, "Γ⁰", toTranslate("Incidence matrix"),
       toTranslate("A row for each link and a column for each joint and mesh: 1 where its arrow ends, −1 "
                   "where it begins."),
       PaperEquation::incidenceMatrix},
      {Term::reducedIncidenceMatrix, "Γ = [G | G*]", toTranslate("Reduced incidence matrix"),
       toTranslate("The incidence matrix without the ground's row, so that its rows are independent. G holds "
                   "the turning joints, G* the meshes."),
       PaperEquation::reducedIncidenceMatrix},
      {Term::pathMatrix, "Z", toTranslate("Path matrix"),
       toTranslate("A column for each link tells its walk through the tree to the ground: 1 where the walk "
                   "runs along a joint, −1 where it runs against it."),
       PaperEquation::pathMatrix},
      {Term::spanningTreeMatrix, "T", toTranslate("Spanning-tree matrix"),
       toTranslate("A row for each mesh tells which turning joints its cycle runs along (1) or against (−1): "
                   "T = G*ᵀ Zᵀ."),
       PaperEquation::spanningTreeMatrix},
      {Term::cycleBasisMatrix, "C = [T | U]", toTranslate("Cycle-basis matrix"),
       toTranslate("A row for each cycle that a mesh closes: T holds its turning joints, the unit matrix U "
                   "its mesh."),
       PaperEquation::cycleBasisMatrix},
      {Term::cutsetMatrix, "Q = [U | −Tᵀ]", toTranslate("Fundamental cutset matrix"),
       toTranslate("A row for each turning joint tells which edges join the two halves that the tree falls "
                   "into without it."),
       PaperEquation::none},
      {Term::digraph, "", toTranslate("Digraph"),
       toTranslate("The mechanism as a directed graph: a node for each link, a solid arrow for each turning "
                   "joint, a dashed arrow for each gear mesh."),
       PaperEquation::none},
      {Term::functionalSchematic, "", toTranslate("Functional schematic"),
       toTranslate("The mechanism in section, with the symbols of ISO 3952: axes dash-dotted, shafts as "
                   "thick lines, bearings as bars about them, gears as pitch lines, the frame hatched."),
       PaperEquation::none},
      {Term::link, "", toTranslate("Link"),
       toTranslate("A rigid body: a gear, a carrier arm, a shaft, or several of them in one."),
       PaperEquation::none},
      {Term::ground, "0", toTranslate("Ground"),
       toTranslate("The fixed link. All others are connected to it by turning joints."), PaperEquation::none},
      {Term::turningJoint, "", toTranslate("Turning joint"),
       toTranslate("Two links that turn relative to each other about an axis. Positive speed turns the head "
                   "about the axis' direction relative to the tail."),
       PaperEquation::none},
      {Term::gearMesh, "", toTranslate("Gear mesh"),
       toTranslate("Two toothed wheels that roll on each other at a pitch point."), PaperEquation::none},
      {Term::input, "", toTranslate("Input"),
       toTranslate("A turning joint that a motor drives at a speed of its own. There are as many as degrees "
                   "of freedom."),
       PaperEquation::freedom},
      {Term::axis, "", toTranslate("Axis"),
       toTranslate("The line that turning joints turn about, the level of the T–T graph. Joints that stay "
                   "coaxial share one."),
       PaperEquation::none},
      {Term::axisPoint, "", toTranslate("Point of the axis"),
       toTranslate("A point that the axis goes through in the reference pose. Without it the axis is placed "
                   "from the tooth counts."),
       PaperEquation::none},
      {Term::axisDirection, "u", toTranslate("Direction of the axis"),
       toTranslate("The direction of the axis in the reference pose, of any length but 0. Positive speed "
                   "turns about it by the right-hand rule."),
       PaperEquation::jointDirection},
      {Term::offset, "", toTranslate("Offset"),
       toTranslate("Where along the axis the bearing is drawn, from the axis' point."), PaperEquation::none},
      {Term::jointLimits, "", toTranslate("Joint limits"),
       toTranslate("How far the joint may turn from the reference pose, both ways, in degrees."),
       PaperEquation::none},
      {Term::teeth, "N", toTranslate("Teeth"),
       toTranslate("The whole number of teeth of a wheel. Pitch diameters are proportional to it."),
       PaperEquation::gearRatios},
      {Term::module, "m", toTranslate("Module"),
       toTranslate("The pitch diameter of a wheel over its teeth, one for both wheels of a mesh; of bevels "
                   "at the large end. Another module moves the axes and changes no ratio."),
       PaperEquation::none},
      {Term::meshKind, "", toTranslate("Kind of mesh"),
       toTranslate(
           "External, internal (one wheel is a ring), bevel (the axes meet), belt or pins (the wheels do not "
           "touch), crossed helical or worm (the axes cross without meeting). Without it the geometry tells "
           "which of the first three it is."),
       PaperEquation::none},
      {Term::helixAngle, "β", toTranslate("Helix angle"),
       toTranslate("Between a tooth and the axis, at the reference cylinder of the first gear. A right-hand "
                   "helix turns "
                   "like a common screw. On parallel axes it changes no ratio; on axes that cross, the hands "
                   "decide which "
                   "way the gears turn."),
       PaperEquation::none},
      {Term::pitchPoint, "", toTranslate("Pitch point"),
       toTranslate("Where the two pitch surfaces touch in the reference pose. Without it the point follows "
                   "from axes and teeth."),
       PaperEquation::offsetVector},
      {Term::gearRatio, "i", toTranslate("Gear ratio"),
       toTranslate("The teeth of the mesh's tail over those of its head."), PaperEquation::gearRatios},
      {Term::spanningTree, "", toTranslate("Spanning tree"),
       toTranslate("The turning joints, if they tie every link to the ground and close no loop."),
       PaperEquation::pathMatrix},
      {Term::cycle, "C15 …", toTranslate("Cycle"),
       toTranslate("A mesh and the path through the tree that leads back from its head to its tail."),
       PaperEquation::cycleBasisMatrix},
      {Term::label, "", toTranslate("Label"),
       toTranslate("The paper's number of a link, joint or mesh. It follows from the order of the elements."),
       PaperEquation::none},
      {Term::screw, "û", toTranslate("Screw"),
       toTranslate("A joint's axis as seen from a pitch point: its unit direction (L M N) and its moment (P "
                   "Q R), the velocity that the point gets for one unit of speed."),
       PaperEquation::screw},
      {Term::coefficientMatrix, "P", toTranslate("Coefficient matrix"),
       toTranslate(
           "A row for each mesh: the moment of each joint of its cycle about the pitch point, times T. P θ̇ = "
           "0 holds for every motion; divided by the head's radius a row holds only ratios and ones."),
       PaperEquation::coefficientMatrix},
      {Term::solution, "θ̇", toTranslate("Solution"),
       toTranslate("The rate of every other joint for one unit of each input: minus the inverse of P's "
                   "output part times its input part."),
       PaperEquation::solutionByInverse},
      {Term::ttGraph, "", toTranslate("T–T graph"),
       toTranslate(
           "The mechanism after Tsai and Tokad: a node for each link, a branch of the tree for each turning "
           "joint with the level it turns on, and for each gear mesh two chords, from its gears to their "
           "carrier arm. An arrow from i to k carries the velocity of link i relative to link k."),
       PaperEquation::none},
      {Term::level, "a, b …", toTranslate("Level"),
       toTranslate("The axis that a branch of the T–T graph turns about. Joints that stay coaxial in every "
                   "motion are on one level."),
       PaperEquation::none},
      {Term::transferVertex, "", toTranslate("Transfer vertex"),
       toTranslate("The carrier arm of a gear mesh: the node on the walk from gear to gear through the tree "
                   "where the level changes."),
       PaperEquation::none},
      {Term::chord, "", toTranslate("Chord"),
       toTranslate("A thin line from a gear of a mesh to its transfer vertex. The two chords of a mesh bear "
                   "the same number of primes. Chords are no part of the tree: each closes one f-circuit."),
       PaperEquation::none},
      {Term::terminalEquation, "", toTranslate("Terminal equation"),
       toTranslate("The relation between the two chords of a mesh: the velocity of gear i relative to the "
                   "carrier arm is that of gear j times ± N(j) / N(i), plus where both gears turn the same "
                   "way, seen from the arm."),
       PaperEquation::gearRelation},
      {Term::fundamentalCircuit, "", toTranslate("f-circuit"),
       toTranslate("A chord and the branches between its two ends: the velocity of the chord is the sum of "
                   "theirs, with signs by their direction. Eqs. (31) to (38) are the paper's."),
       PaperEquation::circuit51},
      {Term::ttCircuitMatrix, "B = [Bₜ | U]", toTranslate("f-circuit matrix of the T–T graph"),
       toTranslate(
           "A row for each f-circuit of the T–T graph: 1 for its own chord; a branch that counts with "
           "plus in the chord's velocity is −1, one that counts with minus is 1. Engaged couplings "
           "are chords, too. B ω = 0 holds for every motion."),
       PaperEquation::circuit51},
      {Term::ttCutsetMatrix, "Q′ = [U | −Bₜᵀ]", toTranslate("f-cutset matrix of the T–T graph"),
       toTranslate("A row for each branch of the T–T graph: 1 for its own torque, and the chords that cross "
                   "the cut, with minus their entries in the f-circuits. Its rows are the equations of the "
                   "T–T graph's statics, and B Q′ᵀ = 0."),
       PaperEquation::none},
  };
  return definitions;
}

const Definition& definitionOf(Term term) {
  const Definition& definition = glossary().at(static_cast<std::size_t>(term));
  GEARGRAPH_REQUIRE(definition.term == term);
  return definition;
}

}  // namespace geargraph
