#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/mesh_geometry.h"

namespace geargraph {

/// The line of action of a pair of which one side turns, about u through p, and the other one slides along d
/// (PairKind::slides). With rho the unit vector from the axis to the pitch point P = p + r rho (+ a way along
/// u), e = u x rho:
///
///     rack    n = cos(beta) e - sin(beta) u,  d square to rho    r = z m_n / (2 cos(beta)), m_n = m_r |n .
///     d| screw   n = cos(g) u -+ sin(g) e,       d = +-u            r = 2 leads, tan(g) = lead / (2 pi r)
///
/// The moment of the turning side is n . (u x (P - p)), that of the sliding side n . d. m_r is the module of
/// the rack along its motion, beta the helix angle of the pinion, whichever end it is. P of a rack is on the
/// side of the slide's line where the document states none. Sets pitch point (tailToPitch), normal, moments,
/// weights, sign and kind. False with pitch-geometry where the joints of its sides are not one of each kind
/// or the lines do not suit the kind, with teeth-geometry where the teeth run along the slide.
/// @pre as checkGeometry()
[[nodiscard]] bool placeSlide(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                              bool tailSlides, bool headSlides, MeshGeometry& geometry,
                              Diagnostics& diagnostics);

}  // namespace geargraph
