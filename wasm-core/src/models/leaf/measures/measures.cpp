#include "models/leaf/measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/leaf/measures/measures.generated.hpp"
#include "plant/measures.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float not_measured = std::numeric_limits<float>::quiet_NaN();
// Leaf lengths along a vein between which its heading is measured, clear of the curve where it leaves; and how far to
// both sides of that place its parent's heading is measured.
constexpr float heading_from = 0.02f, heading_to = 0.08f, parent_reach = 0.05f;
// The same for a primary, clear of where primaries run together at the petiole.
constexpr float primary_from = 0.05f, primary_to = 0.25f;

// The k-th place of a vein.
const glm::vec3& place_of(const Measured& leaf, const Vein& vein, std::size_t k) {
  return leaf.crowds[vein.crowd].places[vein.places[k]];
}

// The length of a vein, in leaf lengths.
float length_of(const Measured& leaf, const Vein& vein) {
  float length = 0;
  for (std::size_t k = 1; k < vein.places.size(); ++k)
    length += glm::distance(place_of(leaf, vein, k - 1), place_of(leaf, vein, k));
  return length;
}

// The point `reach` along a vein from its place k, towards its end (or, `back`, its beginning).
glm::vec3 point_along(const Measured& leaf, const Vein& vein, std::size_t k, float reach, bool back) {
  glm::vec3 at = place_of(leaf, vein, k);
  while (back ? k > 0 : k + 1 < vein.places.size()) {
    const glm::vec3& to = place_of(leaf, vein, back ? --k : ++k);
    const float piece = glm::distance(at, to);
    if (piece >= reach) return at + (reach / piece) * (to - at);
    reach -= piece;
    at = to;
  }
  return at;
}

// The mean angle between neighbouring primaries, in degrees.
float primary_angle_of(const Measured& leaf) {
  std::vector<float> headings;
  for (const Vein& vein : leaf.veins) {
    if (vein.order != 1 || vein.parent >= 0) continue;
    const glm::vec3 way =
        point_along(leaf, vein, 0, primary_to, false) - point_along(leaf, vein, 0, primary_from, false);
    // degrees from upwards, to the left
    if (glm::length(way) > 0) headings.push_back(arc_tangent(-way.x, way.y) * 180 / pi);
  }
  if (headings.size() < 2) return not_measured;
  const auto [least, most] = std::minmax_element(headings.begin(), headings.end());
  return (*most - *least) / static_cast<float>(headings.size() - 1);
}

// Where and how a vein leaves its parent: the distance from the parent's beginning in leaf lengths, the angle in
// degrees, and whether to its left.
struct LeavingPlace {
  float along, angle;  // from the parent's beginning, leaf lengths; degrees
  bool left;
};

// Finds where a vein leaves its parent. Returns false if the vein or the parent has no heading.
bool find_leaving(const Measured& leaf, const Vein& vein, LeavingPlace& found) {
  const Vein& parent = leaf.veins[static_cast<std::size_t>(vein.parent)];
  const auto at = std::find(parent.places.begin(), parent.places.end(), vein.places[0]);
  const auto k = static_cast<std::size_t>(at - parent.places.begin());
  const glm::vec3 heading =
      point_along(leaf, parent, k, parent_reach, false) - point_along(leaf, parent, k, parent_reach, true);
  const glm::vec3 way = point_along(leaf, vein, 0, heading_to, false) - point_along(leaf, vein, 0, heading_from, false);
  const float lengths = glm::length(heading) * glm::length(way);
  if (!(lengths > 0)) return false;
  found.angle = arc_cosine(glm::dot(heading, way) / lengths) * 180 / pi;
  found.left = heading.x * way.y - heading.y * way.x > 0;
  found.along = 0;
  for (std::size_t i = 1; i <= k; ++i)
    found.along += glm::distance(place_of(leaf, parent, i - 1), place_of(leaf, parent, i));
  return true;
}

// Mean angle of secondary veins in degrees, and their mean spacing in leaf lengths.
struct Secondaries {
  float angle = not_measured, spacing = not_measured;  // degrees, leaf lengths
};

// The mean angle of the secondary veins, and their mean distance along the midrib on each side.
Secondaries secondaries_of(const Measured& leaf) {
  struct Place {
    std::int32_t parent;
    bool left;
    float along;
  };
  std::vector<Place> places;
  float angles = 0;
  for (const Vein& vein : leaf.veins) {
    if (vein.order != 2 || vein.parent < 0 || leaf.veins[static_cast<std::size_t>(vein.parent)].order != 1) continue;
    LeavingPlace one{};
    if (!find_leaving(leaf, vein, one)) continue;
    angles += one.angle;
    places.push_back({vein.parent, one.left, one.along});
  }
  std::sort(places.begin(), places.end(), [](const Place& one, const Place& other) {
    if (one.parent != other.parent) return one.parent < other.parent;
    return one.left != other.left ? one.left < other.left : one.along < other.along;
  });
  float gaps = 0, count = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].parent != places[i - 1].parent || places[i].left != places[i - 1].left) continue;
    gaps += places[i].along - places[i - 1].along;
    ++count;
  }
  Secondaries found;
  if (!places.empty()) found.angle = angles / static_cast<float>(places.size());
  if (count > 0) found.spacing = gaps / count;
  return found;
}

// The length of the closed margin, in lengths of the leaf.
float perimeter_of(const Margin& margin) {
  float length = 0;
  for (std::size_t i = 0; i < margin.points.size(); ++i)
    length += glm::distance(margin.points[i], margin.points[(i + 1) % margin.points.size()]);
  return length;
}

}  // namespace

// The measures of a leaf in the order of the table: lengths in millimetres, areas in square centimetres; NaN for those
// that do not apply.
std::vector<float> measures_of(const Measured& leaf) {
  Measures<Measure> values(measure_count);
  const auto set = [&](Measure measure, float value) { values[measure] = value; };
  const float mm = 1000 * leaf.length, surface = leaf.outline.area() * mm * mm, round = perimeter_of(leaf.margin) * mm;
  const glm::vec3 size = leaf.outline.high() - leaf.outline.low();
  using enum Measure;
  set(area, surface / 100);
  set(perimeter, round);
  set(leaf_length, size.y * mm);
  set(leaf_width, size.x * mm);
  set(slenderness, size.y / size.x);
  set(roundness, 4 * pi * surface / (round * round));

  // Sums over veins: lengths by order, the covered area, and the forks, where two pieces or more lead to one place.
  std::uint32_t orders_found = 0, fork_count = 0;
  std::array<float, 3> lengths{}, counts{};
  float whole = 0, covered = 0;
  for (const Vein& vein : leaf.veins) {
    const float length = length_of(leaf, vein) * mm;
    whole += length;
    orders_found = std::max(orders_found, vein.order);
    if (vein.order <= 3) {
      lengths[vein.order - 1] += length;
      ++counts[vein.order - 1];
    }
    const Trails& trails = leaf.crowds[vein.crowd];
    for (std::size_t k = 1; k < vein.places.size(); ++k)
      covered += 2000 * radius_of(leaf.girth, trails.energy[vein.places[k]], leaf.all[vein.crowd]) * mm *
                 glm::distance(place_of(leaf, vein, k - 1), place_of(leaf, vein, k));
  }
  for (const Trails& trails : leaf.crowds) {
    std::vector<std::uint32_t> leading(trails.size(), 0);
    for (const std::int32_t next : trails.next)
      if (next >= 0) ++leading[static_cast<std::size_t>(next)];
    for (std::size_t i = 1; i < trails.size(); ++i) fork_count += leading[i] > 1;
  }
  set(vein_length, whole);
  set(vein_density, whole / surface);
  set(vein_area, covered / surface);
  set(ends, static_cast<float>(leaf.veins.size()));  // each vein has one
  set(forks, static_cast<float>(fork_count));
  set(orders, static_cast<float>(orders_found));
  for (std::uint32_t k = 0; k < 3; ++k) {
    set(static_cast<Measure>(static_cast<std::uint32_t>(count_1) + k), counts[k]);
    set(static_cast<Measure>(static_cast<std::uint32_t>(density_1) + k), 10 * lengths[k] / surface);
  }
  set(primary_angle, primary_angle_of(leaf));
  const Secondaries secondaries = secondaries_of(leaf);
  set(secondary_angle, secondaries.angle);
  set(secondary_spacing, secondaries.spacing * mm);
  return values.take();
}

}  // namespace panicle::particles::leaf
