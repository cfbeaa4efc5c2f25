#pragma once

#include <string>

#include "core/mechanism/model/mechanism.h"
#include "core/theory/matroid/joint_coupling.h"

namespace geargraph {

// The coupling of motors and joints for a robot's controller: matrices of speeds (and of angles from the
// reference pose) and of torques, all exact, with a self-test: the power that goes in comes out. Comments in
// the files are English in every language of the program. @pre the coupling is one of the mechanism

/// "geargraph-coupling" version 1: fractions as texts. With the limits of joints, those of motors: of each
/// alone, and the corners of what all of them together allow (up to kMaxCouplingCorners).
[[nodiscard]] std::string couplingJson(const Mechanism& mechanism, const JointCoupling& coupling);
/// A header of C++17 that needs the standard library only; its self-test runs when it is compiled.
[[nodiscard]] std::string couplingHeader(const Mechanism& mechanism, const JointCoupling& coupling);
/// A module of Python that needs the standard library only; run as a program it tests itself.
[[nodiscard]] std::string couplingPython(const Mechanism& mechanism, const JointCoupling& coupling);
/// <transmission> elements of ros2_control. Parts of the coupling that are a simple, a differential or a four
/// bar linkage transmission there (each joint of one motor; a d = -b c; a triangle) become one; the rest is
/// written as a matrix for a plugin of the user's own, since ros2_control has none for it, and said so.
[[nodiscard]] std::string couplingTransmissions(const Mechanism& mechanism, const JointCoupling& coupling);

constexpr int kMaxCouplingCorners = 64;

}  // namespace geargraph
