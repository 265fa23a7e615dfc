#include "models/bunch/foliage/leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

// The shape of one leaf against the flat one; lengths in midribs.
struct Relief {
  float side, breadth;  // −1: the flat leaf's mirror image; breadth over the flat leaf's
  float pucker;         // of the blade between veins
  float wave;           // of the margin: height
  glm::vec2 waves[2];   // direction across the blade: waves a midrib, and their phases (radians)
  SinCos fold;          // of the two halves, up along the midrib
  float droop, curl;    // radians a midrib: down towards the tip, down towards either side
};

// The random shape in which a leaf bends: its folds, waves and droop, for a seed and how far it has opened and wilted.
Relief relief_of(const LeafOptions& options) {
  const auto between = [&](std::uint64_t address, float low, float high) {
    return low + (high - low) * random_unit(options.seed, hash_text("leaf relief"), address);
  };
  const float opening = options.opening >= 0 ? std::min(options.opening, 1.0f) : 0;
  const float wilting = options.wilting >= 0 ? std::min(options.wilting, 1.0f) : 0;
  Relief relief;
  relief.side = between(6, 0, 1) < 0.5f ? -1.0f : 1.0f;
  relief.breadth = between(7, 0.92f, 1.06f);
  relief.pucker = between(0, 0.03f, 0.05f);
  relief.wave = between(1, 0.08f, 0.15f) * (1 + wilting);
  relief.waves[0] = {between(2, 4, 6.5f), between(8, -pi, pi)};
  relief.waves[1] = {between(9, 4, 6.5f), between(10, -pi, pi)};
  relief.fold = sincos_degrees(between(3, 4, 14) + 48 * (1 - opening) * (1 - opening));
  relief.droop = between(4, 0.45f, 0.95f) + 0.7f * wilting;
  relief.curl = between(5, 0.25f, 0.75f) * opening + 0.5f * wilting;
  return relief;
}

// Raises a point of the flat leaf to its place in the bent one; lengths in midribs. `between`: 0 on a vein … 1 midway
// between veins. The steps are puckers, waves of the margin, the fold along the midrib, then the two bends.
glm::vec3 raise(const Relief& relief, const glm::vec2& flat, float between) {
  const float away = std::min(glm::length(flat), 1.5f);
  glm::vec3 point(relief.side * relief.breadth * flat.x, flat.y, 0);
  point.z += relief.pucker * between * (2 - between) * std::min(1.0f, 4 * away);
  const auto [across, along] = relief.waves;
  point.z += relief.wave * away * away * sine(across.x * flat.x + across.y) * sine(along.x * flat.y + along.y);
  const float off = std::sqrt(point.x * point.x + 0.0025f) - 0.05f;  // rounds the fold
  point.x *= relief.fold.cosine;
  point.z += off * relief.fold.sine;
  bend(point.x, point.z, std::max(relief.curl, 0.05f));
  bend(point.y, point.z, relief.droop);
  return point;
}

}  // namespace

// The mesh of a leaf, bent from its flat outline; in midribs.
Mesh make_leaf(const FlatLeaf& flat, const LeafOptions& options) {
  const Relief relief = relief_of(options);
  std::vector<glm::vec3> places;
  places.reserve(flat.between.size());
  for (std::size_t i = 0; i < flat.between.size(); ++i)
    places.push_back(raise(relief, {flat.points[2 * i], flat.points[2 * i + 1]}, flat.between[i]));
  return raised(flat, places, relief.side < 0);
}

}  // namespace panicle::bunch
