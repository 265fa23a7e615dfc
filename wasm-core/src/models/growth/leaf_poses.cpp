#include "models/growth/leaf_poses.hpp"

#include "foundation/lane_vectors.hpp"

namespace panicle::growth {
namespace {

constexpr float outwards = 0.45f, droop = 0.25f;
constexpr float least = 1e-6f;  // squared length below which a vector has no direction
constexpr float steep = 0.9f;

// Unit vectors orthogonal to four unit vectors, as in foundation/rotation.hpp.
FourVectors any_perpendicular(const FourVectors& way) {
  const Four none = all_of(0);
  const auto level = (way.y < steep) & (way.y > -steep);
  return unit(chosen(level, {-way.z, none, way.x}, {none, way.z, -way.y}));
}

// The four vectors with length 1, or `otherwise` where one has no length.
FourVectors unit(const FourVectors& v, const FourVectors& otherwise) {
  return chosen(dot(v, v) > least, unit(v), otherwise);
}

// Four rotations (quaternions) that take +Y to `up` and +Z to `front`, as turn_to of foundation/rotation.hpp. The
// component that is computed from a square root is chosen by the trace and the largest diagonal element.
std::array<glm::vec4, 4> turns_to(const FourVectors& up, const FourVectors& front) {
  const FourVectors side = cross(up, front);
  const Four trace = side.x + up.y + front.z;
  const Four x = up.z - front.y, y = front.x - side.z, z = side.y - up.x;
  const Four xy = up.x + side.y, zx = front.x + side.z, yz = front.y + up.z;
  const auto none = trace > 0.0f, first = (side.x > up.y) & (side.x > front.z), second = up.y > front.z;
  const Four one = 1.0f + side.x - up.y - front.z, two = 1.0f - side.x + up.y - front.z,
             three = 1.0f - side.x - up.y + front.z;
  const Four i = none ? x : (first ? one : (second ? xy : zx)), j = none ? y : (first ? xy : (second ? two : yz)),
             k = none ? z : (first ? zx : (second ? yz : three)),
             w = none ? 1.0f + trace : (first ? x : (second ? y : z));
  const Four scale = 1.0f / square_root(i * i + j * j + k * k + w * w);
  std::array<glm::vec4, 4> turns{};
  for (int lane = 0; lane < 4; ++lane)
    turns[static_cast<std::size_t>(lane)] = scale[lane] * glm::vec4(i[lane], j[lane], k[lane], w[lane]);
  return turns;
}

// Four unit vectors from a twig's axis to its sides, by random angles.
FourVectors side_of(const Twig& twig, const LeafNoise& noise) {
  const FourSinCos about = sincos_turns(noise.about);
  return about.cosine * all_of(twig.one) + about.sine * all_of(twig.other);
}

}  // namespace

// The rotations of four flat leaves on a twig: tips point outwards and a little down, faces to the sky but for a random
// direction of weight `stray`.
std::array<glm::vec4, 4> leaf_poses(const Twig& twig, const LeafNoise& noise, float stray) {
  const FourVectors along = all_of(twig.along);
  FourVectors out = all_of(0.6f) * along + side_of(twig, noise);
  out.y -= droop;
  out = unit(out);
  const FourSinCos around = sincos_turns(noise.around);
  const Four level = stray * square_root((1.0f - noise.height) * (1.0f + noise.height));
  const FourVectors sky = {all_of(0), all_of(1), all_of(0)};
  const FourVectors sampled = {level * around.cosine, level * around.sine, stray * noise.height};
  const FourVectors face = unit(sky + all_of(outwards) * along + sampled, any_perpendicular(along));
  // The tip points to `out` as nearly as the leaf's face allows.
  return turns_to(unit(out - dot(out, face) * face, any_perpendicular(face)), face);
}

// The rotations of four needles on a twig, which point forward and outwards.
std::array<glm::vec4, 4> needle_poses(const Twig& twig, const LeafNoise& noise) {
  const FourVectors out = unit(all_of(twig.along) + all_of(0.5f) * side_of(twig, noise));
  return turns_to(out, any_perpendicular(out));
}

}  // namespace panicle::growth
