#include "models/bunch/natural/wing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace panicle::bunch {
namespace {

constexpr float fork_in_berries = 0.8f;
constexpr float half_load = 20;     // grams by which a stalk bends halfway down
constexpr float beside = 0.8f;      // length of the stalk beyond the first bunch's half-width, over that
constexpr float own = 0.6f;         // and over its own half-width
constexpr float longest = 0.45f;    // of the first bunch's length
constexpr float shortest = 6;       // millimetres
constexpr float upper_part = 0.5f;  // of the first bunch's length: the part beside which a wing hangs
constexpr int pieces = 6;

// The unit vector of a side of the profile: 0 right, 1 left, 2 front, 3 back.
glm::vec3 direction_of_side(std::size_t side) {
  const float sign = side % 2 == 0 ? 1.0f : -1.0f;
  return side < 2 ? glm::vec3(sign, 0, 0) : glm::vec3(0, 0, sign);
}

// The greatest half-width of an outline on a side, within the upper `share` of its length.
float largest_half_width(const Envelope& envelope, std::size_t side, float share) {
  constexpr int samples = 24;
  float most = 0;
  for (int k = 0; k <= samples; ++k)
    most = std::max(most, envelope.half_width(side, share * envelope.length() * static_cast<float>(k) / samples));
  return most;
}

// A point of a stalk that curves evenly from the angle at which it leaves to `lean` (degrees from straight down),
// `length` long, at a share, 0 … 1, of its length. Summed over short steps.
glm::vec3 stalk_point(const WingStalk& stalk, float lean, float length, float share) {
  constexpr int steps = 12;
  glm::vec3 at(0, stalk.fork, 0);
  for (int k = 0; k < steps; ++k) {
    const float through = share * (static_cast<float>(k) + 0.5f) / steps;
    const SinCos way = sincos_degrees(stalk.angle + (lean - stalk.angle) * through);
    at += (share * length / steps) * (way.sine * direction_of_side(stalk.side) - glm::vec3(0, way.cosine, 0));
  }
  return at;
}

}  // namespace

// The height above p1, the top of the bunch, at which a wing (the second bunch) leaves the peduncle.
float fork_height(float berry_width) { return fork_in_berries * berry_width; }

// How a wing hangs beside the bunch: its lean, its side, and the end of its stalk, which is long enough to keep the two
// apart.
Stance wing_stance(const WingStalk& stalk, const Envelope& bunch, const Envelope& wing) {
  const float lean = stalk.angle / (1 + stalk.load / half_load);
  const std::size_t inner = stalk.side ^ 1;
  const float wanted =
      beside * largest_half_width(bunch, stalk.side, upper_part) + own * largest_half_width(wing, inner, 1);
  const glm::vec3 reach = stalk_point(stalk, lean, 1, 1) - glm::vec3(0, stalk.fork, 0);
  const float out = std::max(0.05f, glm::dot(reach, direction_of_side(stalk.side)));
  const float length = std::clamp(wanted / out, shortest, std::max(shortest, longest * bunch.length()));
  return {lean, stalk.side, stalk_point(stalk, lean, length, 1)};
}

// The stalk of a wing as a chain of pieces, with a width that changes evenly from `width` at its foot to `width_end`.
std::vector<Internode> wing_stalk(const WingStalk& stalk, const Stance& stance, float width, float width_end) {
  const float unit = glm::dot(stalk_point(stalk, stance.lean, 1, 1), direction_of_side(stalk.side));
  const float length = glm::dot(stance.foot, direction_of_side(stalk.side)) / unit;
  std::vector<Internode> all;
  for (int k = 0; k < pieces; ++k) {
    const float from = static_cast<float>(k) / pieces, to = static_cast<float>(k + 1) / pieces;
    Internode piece;
    piece.parent = k - 1;
    piece.start = all.empty() ? stalk_point(stalk, stance.lean, length, 0) : all.back().end;
    piece.end = k + 1 == pieces ? stance.foot : stalk_point(stalk, stance.lean, length, to);
    piece.radius = (width + (width_end - width) * from) / 2;
    piece.radius_end = (width + (width_end - width) * to) / 2;
    piece.joint = k > 0;
    all.push_back(piece);
  }
  return all;
}

}  // namespace panicle::bunch
