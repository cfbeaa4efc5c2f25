#include "core/presentation/scene/render_style.h"

namespace geargraph {

RenderStyle RenderStyle::light() {
  RenderStyle style;
  style.groundTop = Rgb::fromHex(0xEFF2F6);
  style.groundBottom = Rgb::fromHex(0xD3D9E1);
  style.disc = Rgb::fromHex(0x5A6475);
  style.discStrength = 0.15F;
  style.shadow = Rgb::fromHex(0x3A4352);
  style.shadowStrength = 0.34F;
  style.edge = Rgb::fromHex(0x1B1F25);
  style.edgeStrength = 0.4F;
  style.accent = Rgb::fromHex(0x2A68E4);
  style.letters = Rgb::fromHex(0x23272E);
  return style;
}

RenderStyle RenderStyle::dark() {
  RenderStyle style;
  style.groundTop = Rgb::fromHex(0x3C444F);
  style.groundBottom = Rgb::fromHex(0x21262C);
  style.disc = Rgb::fromHex(0x8A97A8);
  style.discStrength = 0.13F;
  style.shadow = Rgb::fromHex(0x0B0D10);
  style.shadowStrength = 0.55F;
  style.edge = Rgb::fromHex(0x0B0D10);
  style.edgeStrength = 0.45F;
  style.accent = Rgb::fromHex(0x6C9BFF);
  style.letters = Rgb::fromHex(0xE6E9EE);
  return style;
}

RenderStyle RenderStyle::cheaper() const {
  RenderStyle style = *this;
  style.samples = 1;
  style.contactShadow = false;
  return style;
}

}  // namespace geargraph
