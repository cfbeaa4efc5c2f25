#pragma once

namespace geargraph::shaders {

// GLSL 3.30 core, without the version line. Lengths in mm, directions in the eye's frame.

/// A triangle without vertex data that fills the picture; `v_place` runs over 0..1 from the lower left.
inline constexpr const char* kFullVertex = R"(
out vec2 v_place;
void main() {
  v_place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * v_place - 1.0, 0.0, 1.0);
})";

inline constexpr const char* kGradientFragment = R"(
uniform vec3 u_top;
uniform vec3 u_bottom;
in vec2 v_place;
out vec4 o_colour;
void main() {
  // a grain of less than one step of a byte, against bands
  float grain = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
  o_colour = vec4(mix(u_bottom, u_top, v_place.y) + grain / 255.0, 1.0);
})";

/// u_nearer < 1 draws nearer to the eye by that factor, so that lines win against their own faces.
inline constexpr const char* kSolidVertex = R"(
uniform mat4 u_projection;
uniform float u_nearer;
uniform vec4 u_section;  // what is beyond this plane is cut away, where cutting is switched on
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in mat4 a_modelView;  // from here on one an instance
layout(location = 6) in vec4 a_colour;
layout(location = 7) in vec4 a_accent;
out vec3 v_normal;
out vec3 v_position;
flat out vec4 v_colour;
flat out vec4 v_accent;
void main() {
  v_colour = a_colour;
  v_accent = a_accent;
  vec4 seen = a_modelView * vec4(a_position, 1.0);
  v_position = seen.xyz;
  gl_ClipDistance[0] = u_section.w - dot(u_section.xyz, seen.xyz);
  v_normal = mat3(a_modelView) * a_normal;
  gl_Position = u_projection * vec4(seen.xyz * u_nearer, 1.0);
})";

/// A matte material: faces towards the top and the key light brighten to a pastel of the part's colour,
/// flanks darken to half of it, without black or glare. The key light is at the viewer's upper left, the fill
/// light at the right; a rim light separates a silhouette from its background. Prepended to the shaders that
/// light solids.
inline constexpr const char* kLight = R"(
uniform vec3 u_up;
const vec3 kKey = vec3(-0.48, 0.55, 0.68);
const vec3 kFill = vec3(0.78, 0.12, 0.61);
vec3 litColour(vec3 n, vec3 toEye, vec3 colour) {
  float key = max(dot(n, kKey), 0.0);
  float fill = max(dot(n, kFill), 0.0);
  float sky = 0.5 + 0.5 * dot(n, u_up);
  float shade = 0.38 + 0.22 * sky + 0.64 * key + 0.14 * fill;
  float grazing = 1.0 - max(dot(n, toEye), 0.0);
  float rim = 0.16 * grazing * grazing * grazing * sky;
  vec3 lit = shade < 1.0 ? colour * shade : mix(colour, vec3(1.0), min(1.5 * (shade - 1.0), 0.3));
  return mix(lit, vec3(1.0), rim);
})";

inline constexpr const char* kSolidFragment = R"(
in vec3 v_normal;
in vec3 v_position;
flat in vec4 v_colour;
flat in vec4 v_accent;
out vec4 o_colour;
void main() {
  vec3 n = normalize(gl_FrontFacing ? v_normal : -v_normal);  // the inside of an open solid
  vec3 lit = litColour(n, normalize(-v_position), v_colour.rgb);
  o_colour = vec4(mix(lit, v_accent.rgb, v_accent.a), v_colour.a);
})";

/// The same lighting per vertex: two thirds of the time in software rendering. For closed solids without a
/// section only, because back faces have no normals of their own here.
inline constexpr const char* kByVertexVertex = R"(
uniform mat4 u_projection;
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in mat4 a_modelView;
layout(location = 6) in vec4 a_colour;
layout(location = 7) in vec4 a_accent;
out vec4 v_colour;
void main() {
  vec4 seen = a_modelView * vec4(a_position, 1.0);
  vec3 lit = litColour(normalize(mat3(a_modelView) * a_normal), normalize(-seen.xyz), a_colour.rgb);
  v_colour = vec4(mix(lit, a_accent.rgb, a_accent.a), a_colour.a);
  gl_Position = u_projection * vec4(seen.xyz, 1.0);
})";

inline constexpr const char* kByVertexFragment = R"(
in vec4 v_colour;
out vec4 o_colour;
void main() { o_colour = v_colour; })";

/// One colour: feature edges, masks, numbers of instances.
inline constexpr const char* kFlatFragment = R"(
flat in vec4 v_colour;
out vec4 o_colour;
void main() { o_colour = v_colour; })";

/// The floor disc: a square in the plane z = u_disc.z about (x, y), of half side u_disc.w, at the depth of
/// the far plane, so that it can also be painted after the parts.
inline constexpr const char* kDiscVertex = R"(
uniform mat4 u_modelView;
uniform mat4 u_projection;
uniform vec4 u_disc;
out vec2 v_place;
void main() {
  v_place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec3 point = vec3(u_disc.xy + (2.0 * v_place - 1.0) * u_disc.w, u_disc.z);
  gl_Position = u_projection * (u_modelView * vec4(point, 1.0));
  gl_Position.z = gl_Position.w;
})";

inline constexpr const char* kDiscFragment = R"(
uniform vec3 u_colour;
uniform vec3 u_shade;
uniform vec2 u_strength;  // of the disc, of the shadow
uniform sampler2D u_shadow;
in vec2 v_place;
out vec4 o_colour;
void main() {
  float radius = length(2.0 * v_place - 1.0);
  float disc = u_strength.x * (1.0 - smoothstep(0.93, 0.99, radius));
  float shadow = u_strength.y * texture(u_shadow, v_place).r * (1.0 - smoothstep(0.75, 1.0, radius));
  float alpha = shadow + disc * (1.0 - shadow);
  o_colour = vec4(mix(u_colour, u_shade, shadow / max(alpha, 0.001)), alpha);
})";

/// The parts seen from above in the shadow's square: the nearer to the floor, the darker.
inline constexpr const char* kShadowVertex = R"(
uniform vec4 u_disc;
uniform float u_reach;
layout(location = 0) in vec3 a_position;
layout(location = 2) in mat4 a_modelView;  // to the world
out float v_darkness;
void main() {
  vec3 point = (a_modelView * vec4(a_position, 1.0)).xyz;
  v_darkness = exp(-max(point.z - u_disc.z, 0.0) / u_reach);
  gl_Position = vec4((point.xy - u_disc.xy) / u_disc.w, 0.0, 1.0);
})";

inline constexpr const char* kShadowFragment = R"(
in float v_darkness;
out vec4 o_colour;
void main() { o_colour = vec4(v_darkness); })";

/// One direction of a Gaussian blur; u_step is one texel along it.
inline constexpr const char* kBlurFragment = R"(
uniform sampler2D u_image;
uniform vec2 u_step;
in vec2 v_place;
out vec4 o_colour;
void main() {
  float sum = 0.0;
  float weights = 0.0;
  for (int k = -8; k <= 8; ++k) {
    float weight = exp(-float(k * k) / 26.0);
    sum += weight * texture(u_image, v_place + float(k) * u_step).r;
    weights += weight;
  }
  o_colour = vec4(sum / weights);
})";

/// The glow around selected and hovered parts: how much of the mask is near, outside of it.
inline constexpr const char* kHaloFragment = R"(
uniform sampler2D u_mask;
uniform vec2 u_step;
uniform vec4 u_halo;
in vec2 v_place;
out vec4 o_colour;
void main() {
  float nearest = 0.0;
  for (int ring = 1; ring <= 3; ++ring) {
    for (int k = 0; k < 8; ++k) {
      float angle = 0.7853982 * float(k) + 0.3926991 * float(ring);
      vec2 away = float(ring) * vec2(cos(angle), sin(angle)) * u_step;
      nearest = max(nearest, texture(u_mask, v_place + away).r * (1.25 - 0.25 * float(ring)));
    }
  }
  float inside = texture(u_mask, v_place).r;
  o_colour = vec4(u_halo.rgb, u_halo.a * nearest * (1.0 - inside));
})";

/// Coloured triangles in pixels; u_size is the picture's.
inline constexpr const char* kOverlayVertex = R"(
uniform vec2 u_size;
layout(location = 0) in vec2 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in float a_depth;
out vec3 v_colour;
void main() {
  v_colour = a_normal;
  gl_Position = vec4(2.0 * a_position.x / u_size.x - 1.0, 1.0 - 2.0 * a_position.y / u_size.y, a_depth, 1.0);
})";

inline constexpr const char* kOverlayFragment = R"(
uniform float u_alpha;
in vec3 v_colour;
out vec4 o_colour;
void main() { o_colour = vec4(v_colour, u_alpha); })";

/// A square in the cutting plane, about u_centre, with the half sides u_right and u_upward.
inline constexpr const char* kCapVertex = R"(
uniform mat4 u_modelView;  // of the world
uniform mat4 u_projection;
uniform vec3 u_centre;
uniform vec3 u_right;
uniform vec3 u_upward;
out vec2 v_place;  // mm in the plane
void main() {
  vec2 corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  v_place = corner * length(u_right) + vec2(dot(u_centre, normalize(u_right)), dot(u_centre, normalize(u_upward)));
  vec3 world = u_centre + corner.x * u_right + corner.y * u_upward;
  gl_ClipDistance[0] = 1.0;
  gl_Position = u_projection * u_modelView * vec4(world, 1.0);
})";

/// Hatched as in a drawing: lines at 45 degrees, leaning one way or the other, u_hatch.x mm apart.
inline constexpr const char* kCapFragment = R"(
uniform vec3 u_colour;
uniform vec2 u_hatch;  // distance; +1 or -1
in vec2 v_place;
out vec4 o_colour;
void main() {
  float across = (v_place.x + u_hatch.y * v_place.y) / (1.4142 * u_hatch.x);
  float from = abs(fract(across) - 0.5);
  float pixel = max(fwidth(across), 1e-6);
  float line = 1.0 - smoothstep(0.6, 1.6, (0.5 - from) / pixel);
  line *= clamp(0.25 / pixel, 0.0, 1.0);  // too fine to be told apart: none
  o_colour = vec4(mix(mix(u_colour, vec3(1.0), 0.35), u_colour * 0.45, 0.7 * line), 1.0);
})";

}  // namespace geargraph::shaders
