#include "core/presentation/painting/look.h"

namespace geargraph::inline painting {

Look Look::light() {
  Look look;
  look.groundTop = Rgb::fromHex(0xEFF2F6);
  look.groundBottom = Rgb::fromHex(0xD3D9E1);
  look.disc = Rgb::fromHex(0x5A6475);
  look.discStrength = 0.15F;
  look.shadow = Rgb::fromHex(0x3A4352);
  look.shadowStrength = 0.34F;
  look.edge = Rgb::fromHex(0x1B1F25);
  look.edgeStrength = 0.4F;
  look.accent = Rgb::fromHex(0x2F6FED);
  look.letters = Rgb::fromHex(0x23272E);
  return look;
}

Look Look::dark() {
  Look look;
  look.groundTop = Rgb::fromHex(0x3C444F);
  look.groundBottom = Rgb::fromHex(0x21262C);
  look.disc = Rgb::fromHex(0x8A97A8);
  look.discStrength = 0.13F;
  look.shadow = Rgb::fromHex(0x0B0D10);
  look.shadowStrength = 0.55F;
  look.edge = Rgb::fromHex(0x0B0D10);
  look.edgeStrength = 0.45F;
  look.accent = Rgb::fromHex(0x6C9BFF);
  look.letters = Rgb::fromHex(0xE6E9EE);
  return look;
}

Look Look::cheaper() const {
  Look look = *this;
  look.samples = 1;
  look.contactShadow = false;
  return look;
}

}  // namespace geargraph::inline painting
