#include "core/teaching/grading/mistake_names.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

std::span<const MistakeName> mistakeNames() {
  static constexpr MistakeName kNames[] = {
      // of any answer
      {"unanswered", toTranslate("field left empty")},
      {"not-a-number", toTranslate("text that is no number")},
      {"ambiguous-number", toTranslate("comma that may be a decimal or a thousand")},
      {"unknown-symbol", toTranslate("symbol that the question does not know")},
      {"other-unit", toTranslate("number in another unit")},
      {"not-a-choice", toTranslate("text that the question does not offer")},
      // matrices of whole numbers
      {"incidence-exchanged", toTranslate("incidence with + and − exchanged")},
      {"arrow-reversed", toTranslate("tail and head of an arrow exchanged")},
      {"signs-left-out", toTranslate("signs left out")},
      {"end-left-out", toTranslate("an end of an arrow left out")},
      {"not-an-end", toTranslate("a link that is no end of the arrow")},
      {"ground-row-left-in", toTranslate("ground row left in")},
      {"ground-row-left-out", toTranslate("ground row left out")},
      {"transposed", toTranslate("rows and columns exchanged")},
      {"entry-not-a-sign", toTranslate("entry that is not −1, 0 or 1")},
      {"walked-against-arrow", toTranslate("arrow walked against its direction")},
      {"joint-left-out", toTranslate("joint of the walk left out")},
      {"joint-off-the-walk", toTranslate("joint that is not on the walk")},
      {"another-cycle", toTranslate("another cycle's row")},
      {"cycle-backwards", toTranslate("cycle walked against its mesh")},
      {"own-mesh-left-out", toTranslate("the cycle's own mesh left out")},
      {"another-mesh-in-cycle", toTranslate("another mesh in the cycle")},
      {"walk-from-ground", toTranslate("walked from the ground instead of to it")},
      {"another-link", toTranslate("another link's walk")},
      {"another-joint", toTranslate("another joint's cutset")},
      {"cutset-as-cycle", toTranslate("signs of the cycle instead of the cutset")},
      {"mesh-not-cut", toTranslate("mesh that the cutset does not cut")},
      {"mesh-not-counted", toTranslate("mesh that the cutset cuts left out")},
      {"crosses-backwards", toTranslate("edge that crosses the cut the other way")},
      {"joint-in-cutset", toTranslate("another turning joint in the cutset")},
      // cycles and trees
      {"mesh-among-joints", toTranslate("mesh listed among the turning joints")},
      {"paths-to-ground", toTranslate("both paths followed to the ground")},
      {"one-gear-only", toTranslate("path of one gear only")},
      {"too-few-edges", toTranslate("too few edges for a spanning tree")},
      {"too-many-edges", toTranslate("too many edges for a spanning tree")},
      {"closes-a-loop", toTranslate("edges that close a loop")},
      {"required-edge-missing", toTranslate("the required edge is not in the tree")},
      {"orientation-lost", toTranslate("senses that do not follow one walk")},
      // P, terminal equations and circuits
      {"ratio-upside-down", toTranslate("ratio upside down")},
      {"internal-as-external", toTranslate("internal mesh with an external sign")},
      {"external-as-internal", toTranslate("external mesh with an internal sign")},
      {"bevel-sign", toTranslate("sign of a bevel mesh")},
      {"belt-sign", toTranslate("sign of a belt")},
      {"pins-sign", toTranslate("sign of pins in holes")},
      {"rack-sign", toTranslate("sign of a rack")},
      {"screw-sign", toTranslate("sign of a screw")},
      {"crossed-sign", toTranslate("sign of gears on axes that cross")},
      {"sign-and-ratio", toTranslate("sign wrong and ratio upside down")},
      {"coefficients-left-out", toTranslate("row of C in place of P")},
      {"arrow-sense-lost", toTranslate("coefficients without the signs of the cycle")},
      {"teeth-of-another-wheel", toTranslate("teeth of another wheel on the same link")},
      {"chord-backwards", toTranslate("chord followed from the carrier to the gear")},
      {"another-chord", toTranslate("circuit of the other chord")},
      {"circuit-to-ground", toTranslate("circuit followed to the ground instead of the carrier")},
      {"whole-walk", toTranslate("circuit of the whole walk between the gears")},
      {"levels-exchanged", toTranslate("levels of the two gears exchanged")},
      {"wrong-level", toTranslate("transfer vertex where the level does not change")},
      {"gear-as-carrier", toTranslate("gear taken for the carrier")},
      {"ground-as-carrier", toTranslate("ground taken for the carrier")},
      {"carrier-off-the-path", toTranslate("carrier that is not on the path")},
      {"level-off-the-path", toTranslate("level that is not on the path")},
      {"torque-as-speed", toTranslate("velocity relation used for torques")},
      {"torque-sign", toTranslate("port torque with the wrong sign")},
      // rank, freedom, inputs
      {"kutzbach-with-redundant-mesh", toTranslate("Kutzbach's count where a mesh is redundant")},
      {"ground-counted", toTranslate("ground counted as a moving link")},
      {"rank-and-dof-exchanged", toTranslate("rank and degrees of freedom exchanged")},
      {"mesh-takes-two", toTranslate("two freedoms taken by a mesh")},
      {"meshes-ignored", toTranslate("meshes ignored")},
      {"not-t-minus-r", toTranslate("degrees of freedom that are not t − r")},
      {"too-few-inputs", toTranslate("too few inputs")},
      {"too-many-inputs", toTranslate("too many inputs")},
      {"dependent-inputs", toTranslate("inputs that depend on each other")},
      {"dead-input", toTranslate("a joint that can never turn as input")},
      {"idle-joint-missing", toTranslate("a joint that no mesh drives is not an input")},
      {"independent-mesh", toTranslate("mesh on which no other depends")},
      {"redundancy-overlooked", toTranslate("no mesh taken for redundant")},
      {"redundancy-miscounted", toTranslate("number of redundant meshes")},
      // speeds and teeth
      {"sign-lost", toTranslate("sign of the speed lost")},
      {"input-ignored", toTranslate("an input ignored")},
      {"mesh-sign", toTranslate("sign of one mesh in the chain")},
      {"absolute-for-relative", toTranslate("absolute speed in place of the joint's rate")},
      {"carrier-ignored", toTranslate("motion of the carrier ignored")},
      {"speed-inverted", toTranslate("whole ratio upside down")},
      {"teeth-out-of-range", toTranslate("number of teeth out of the range")},
      {"ratio-not-met", toTranslate("teeth that do not make the ratio")},
      {"ring-teeth-added", toTranslate("teeth of the ring added")},
      {"planet-counted-once", toTranslate("planet counted once in the ring")},
      // states
      {"another-gear", toTranslate("couplings of another gear")},
      {"drive-locked", toTranslate("couplings that lock the drive")},
      {"too-free", toTranslate("too few couplings to leave one freedom")},
      {"another-ratio", toTranslate("couplings that make another ratio")},
      // torques of couplings and losses
      {"released-coupling", toTranslate("brake or clutch that is released")},
      {"smaller-torque", toTranslate("a smaller torque taken for the largest")},
      {"fastest-coupling", toTranslate("the fastest clutch instead of that of the largest torque")},
      {"largest-ratio", toTranslate("the largest ratio instead of the largest torque")},
      {"torques-without-signs", toTranslate("torques added without their signs")},
      {"torque-of-another", toTranslate("torque of another brake, clutch or state")},
      {"load-for-brake", toTranslate("torque of the load in place of that of the brake")},
      {"drive-for-brake", toTranslate("torque of the drive in place of that of the brake")},
      {"reaction-for-action", toTranslate("torque on the housing in place of that on the link")},
      {"same-sense-on-both", toTranslate("brake that turns link and housing in the same sense")},
      {"forward-for-backward", toTranslate("efficiency forward in place of backward")},
      {"losses-ignored", toTranslate("losses left out")},
      {"fixed-axis-losses", toTranslate("losses of a planetary train as of fixed axes")},
      {"efficiency-upside-down", toTranslate("efficiency upside down")},
      {"lock-overlooked", toTranslate("self-locking train taken for one that turns")},
      {"lock-claimed", toTranslate("train that turns taken for a self-locking one")},
      {"locked-with-power", toTranslate("efficiency of a train that locks itself")},
      // wrong entries
      {"right-row-only", toTranslate("right row, wrong column")},
      {"right-column-only", toTranslate("right column, wrong row")},
      {"right-entry-blamed", toTranslate("an entry that is right")},
      {"wrong-correction", toTranslate("right place, wrong correction")},
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

}  // namespace geargraph
