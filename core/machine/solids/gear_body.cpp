#include "core/machine/solids/gear_body.h"

#include "core/machine/solids/wheel_form.h"

namespace geargraph {

std::vector<ProfileVertex> bodyProfile(const GearSpec& spec) {
  return wheelForm(spec).body(spec);
}

std::vector<ProfileVertex> wheelOutline(const GearSpec& spec) {
  return wheelForm(spec).outline(spec);
}

std::optional<WebWindows> bodyWindows(const GearSpec& spec) {
  return wheelForm(spec).windows(spec);
}

double rimDiameter(const GearSpec& spec) {
  return spec.rim > 0 ? spec.rim : 2 * (nominalRootRadius(spec) + 2 * spec.module);
}

double outerRadius(const GearSpec& spec) {
  return isRing(spec) ? rimDiameter(spec) / 2 : nominalTipRadius(spec);
}

double largestBore(const GearSpec& spec) {
  return wheelForm(spec).largestBore(spec);
}

AxialSpan axialSpan(const GearSpec& spec) {
  return wheelForm(spec).span(spec);
}

AxialSpan hubSpan(const GearSpec& spec) {
  return spanOf(bodyProfile(spec));
}

}  // namespace geargraph
