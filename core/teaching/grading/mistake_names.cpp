#include "core/teaching/grading/mistake_names.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"

namespace geargraph::inline grading {

std::span<const MistakeName> mistakeNames() {
  static constexpr MistakeName kNames[] = {
      // of any answer
      {"unanswered", "field left empty"},
      {"not-a-number", "text that is no number"},
      {"ambiguous-number", "comma that may be a decimal or a thousand"},
      {"not-a-choice", "text that the question does not offer"},
      // matrices of whole numbers
      {"incidence-exchanged", "incidence with + and − exchanged"},
      {"arrow-reversed", "tail and head of an arrow exchanged"},
      {"signs-left-out", "signs left out"},
      {"end-left-out", "an end of an arrow left out"},
      {"not-an-end", "a link that is no end of the arrow"},
      {"ground-row-left-in", "ground row left in"},
      {"ground-row-left-out", "ground row left out"},
      {"transposed", "rows and columns exchanged"},
      {"entry-not-a-sign", "entry that is not −1, 0 or 1"},
      {"walked-against-arrow", "arrow walked against its direction"},
      {"joint-left-out", "joint of the walk left out"},
      {"joint-off-the-walk", "joint that is not on the walk"},
      {"another-cycle", "another cycle's row"},
      {"cycle-backwards", "cycle walked against its mesh"},
      {"own-mesh-left-out", "the cycle's own mesh left out"},
      {"another-mesh-in-cycle", "another mesh in the cycle"},
      {"walk-from-ground", "walked from the ground instead of to it"},
      {"another-link", "another link's walk"},
      {"another-joint", "another joint's cutset"},
      {"cutset-as-cycle", "signs of the cycle instead of the cutset"},
      {"mesh-not-cut", "mesh that the cutset does not cut"},
      {"mesh-not-counted", "mesh that the cutset cuts left out"},
      {"crosses-backwards", "edge that crosses the cut the other way"},
      {"joint-in-cutset", "another turning joint in the cutset"},
      // cycles and trees
      {"mesh-among-joints", "mesh listed among the turning joints"},
      {"paths-to-ground", "both paths followed to the ground"},
      {"one-gear-only", "path of one gear only"},
      {"too-few-edges", "too few edges for a spanning tree"},
      {"too-many-edges", "too many edges for a spanning tree"},
      {"closes-a-loop", "edges that close a loop"},
      {"required-edge-missing", "the required edge is not in the tree"},
      {"orientation-lost", "senses that do not follow one walk"},
      // P, terminal equations and circuits
      {"ratio-upside-down", "ratio upside down"},
      {"internal-as-external", "internal mesh with an external sign"},
      {"external-as-internal", "external mesh with an internal sign"},
      {"bevel-sign", "sign of a bevel mesh"},
      {"sign-and-ratio", "sign wrong and ratio upside down"},
      {"coefficients-left-out", "row of C in place of P"},
      {"arrow-sense-lost", "coefficients without the signs of the cycle"},
      {"teeth-of-another-wheel", "teeth of another wheel on the same link"},
      {"chord-backwards", "chord followed from the carrier to the gear"},
      {"another-chord", "circuit of the other chord"},
      {"circuit-to-ground", "circuit followed to the ground instead of the carrier"},
      {"whole-walk", "circuit of the whole walk between the gears"},
      {"levels-exchanged", "levels of the two gears exchanged"},
      {"wrong-level", "transfer vertex where the level does not change"},
      {"gear-as-carrier", "gear taken for the carrier"},
      {"ground-as-carrier", "ground taken for the carrier"},
      {"carrier-off-the-path", "carrier that is not on the path"},
      {"level-off-the-path", "level that is not on the path"},
      {"torque-as-speed", "velocity relation used for torques"},
      {"torque-sign", "port torque with the wrong sign"},
      // rank, freedom, inputs
      {"kutzbach-with-redundant-mesh", "Kutzbach's count where a mesh is redundant"},
      {"ground-counted", "ground counted as a moving link"},
      {"rank-and-dof-exchanged", "rank and degrees of freedom exchanged"},
      {"mesh-takes-two", "two freedoms taken by a mesh"},
      {"meshes-ignored", "meshes ignored"},
      {"not-t-minus-r", "degrees of freedom that are not t − r"},
      {"too-few-inputs", "too few inputs"},
      {"too-many-inputs", "too many inputs"},
      {"dependent-inputs", "inputs that depend on each other"},
      {"dead-input", "a joint that can never turn as input"},
      {"idle-joint-missing", "a joint that no mesh drives is not an input"},
      {"independent-mesh", "mesh on which no other depends"},
      {"redundancy-overlooked", "no mesh taken for redundant"},
      {"redundancy-miscounted", "number of redundant meshes"},
      // speeds and teeth
      {"sign-lost", "sign of the speed lost"},
      {"input-ignored", "an input ignored"},
      {"mesh-sign", "sign of one mesh in the chain"},
      {"absolute-for-relative", "absolute speed in place of the joint's rate"},
      {"carrier-ignored", "motion of the carrier ignored"},
      {"speed-inverted", "whole ratio upside down"},
      {"teeth-out-of-range", "number of teeth out of the range"},
      {"ratio-not-met", "teeth that do not make the ratio"},
      {"ring-teeth-added", "teeth of the ring added"},
      {"planet-counted-once", "planet counted once in the ring"},
      // states
      {"another-gear", "couplings of another gear"},
      {"drive-locked", "couplings that lock the drive"},
      {"too-free", "too few couplings to leave one freedom"},
      {"another-ratio", "couplings that make another ratio"},
      // torques of couplings and losses
      {"released-coupling", "brake or clutch that is released"},
      {"smaller-torque", "a smaller torque taken for the largest"},
      {"fastest-coupling", "the fastest clutch instead of that of the largest torque"},
      {"largest-ratio", "the largest ratio instead of the largest torque"},
      {"torques-without-signs", "torques added without their signs"},
      {"torque-of-another", "torque of another brake, clutch or state"},
      {"load-for-brake", "torque of the load in place of that of the brake"},
      {"drive-for-brake", "torque of the drive in place of that of the brake"},
      {"reaction-for-action", "torque on the housing in place of that on the link"},
      {"same-sense-on-both", "brake that turns link and housing in the same sense"},
      {"forward-for-backward", "efficiency forward in place of backward"},
      {"losses-ignored", "losses left out"},
      {"fixed-axis-losses", "losses of a planetary train as of fixed axes"},
      {"efficiency-upside-down", "efficiency upside down"},
      {"lock-overlooked", "self-locking train taken for one that turns"},
      {"lock-claimed", "train that turns taken for a self-locking one"},
      {"locked-with-power", "efficiency of a train that locks itself"},
      // wrong entries
      {"right-row-only", "right row, wrong column"},
      {"right-column-only", "right column, wrong row"},
      {"right-entry-blamed", "an entry that is right"},
      {"wrong-correction", "right place, wrong correction"},
  };
  return kNames;
}

std::string_view mistakeTitle(std::string_view name) {
  const auto names = mistakeNames();
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const MistakeName& n) { return n.name == name; });
  GEARGRAPH_REQUIRE(found != names.end());
  return found->title;
}

}  // namespace geargraph::inline grading
