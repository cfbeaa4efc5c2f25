#pragma once

#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "core/presentation/brep/brep.h"

namespace geargraph {

/// The solid as OpenCASCADE has it, with the curves of its edges on its faces. Throws Standard_Failure where
/// OpenCASCADE cannot have such a face. @pre flawOf(solid) is std::nullopt
[[nodiscard]] TopoDS_Solid occSolid(const Brep& solid);

[[nodiscard]] double volumeOf(const TopoDS_Shape& shape);

/// All solids as one shape: united where that gives a valid one of a volume that can be, else all of them as
/// they are.
[[nodiscard]] TopoDS_Shape united(const std::vector<TopoDS_Solid>& solids);

/// Is it what OpenCASCADE takes for a valid shape?
[[nodiscard]] bool isValid(const TopoDS_Shape& shape);

}  // namespace geargraph
