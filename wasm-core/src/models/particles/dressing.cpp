#include "models/particles/dressing.hpp"

#include <string>
#include <utility>

#include "light/sky_visibility.hpp"
#include "stems/wood.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

namespace {

// The number of the axis (unbranched run of stem) that each segment belongs to: at a fork the trail with the most
// energy continues the axis, each other one begins a new axis.
std::vector<std::int32_t> axes_of(const GrownWood& grown, std::size_t segments) {
  std::vector<std::int32_t> axes(segments, 0);
  std::int32_t count = 0;
  for (std::size_t c = 0; c < grown.trails.size(); ++c) {
    const Trails& trails = grown.trails[c];
    const std::vector<std::int32_t>& numbers = grown.numbers[c];
    std::vector<std::int32_t> heaviest(trails.size(), -1);
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      std::int32_t& best = heaviest[static_cast<std::size_t>(trails.next[i])];
      if (best < 0 || trails.energy[i] > trails.energy[static_cast<std::size_t>(best)])
        best = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < trails.size(); ++i) {
      const std::int32_t segment = numbers[i];
      if (segment < 0) continue;
      const auto next = static_cast<std::size_t>(trails.next[i]);
      const bool goes_on = numbers[next] >= 0 && heaviest[next] == static_cast<std::int32_t>(i);
      axes[static_cast<std::size_t>(segment)] = goes_on ? axes[static_cast<std::size_t>(numbers[next])] : count++;
    }
  }
  return axes;
}

// The leaves as occluders of the sky: disc of half a leaf's area at each organ with the tag `leaf_tag`. `leaf_area` is
// that of scale 1.
std::vector<Occluder> leaves_of(const Plant& plant, std::uint32_t leaf_tag, float leaf_area) {
  std::vector<Occluder> leaves;
  for (const Organ& organ : plant.organs)
    if (organ.tag == leaf_tag) leaves.push_back({organ.position, 0.5f * leaf_area * organ.scale * organ.scale});
  return leaves;
}

}  // namespace

// Adds the stems' mesh to the plant and, if the habit wants it, the visible share of the sky at its vertices and
// organs.
void dress(Plant& plant, const GrownWood& grown, const DressHabit& habit) {
  std::vector<glm::vec3> targets;
  for (const Trails& trails : grown.wood.crowds)
    if (trails.size() > 0) targets.push_back(trails.places[0]);
  StemMesh stems = sweep_wood(plant.segments, axes_of(grown, plant.segments.size()), targets, habit.foot);
  Columns columns;
  if (habit.sky) {
    const SkyVisibility open(plant.segments, leaves_of(plant, habit.leaf, habit.leaf_area));
    std::vector<std::uint8_t> of_organs;
    for (const Organ& organ : plant.organs) of_organs.push_back(open.at(organ.position));
    columns.add("sky", open.of(stems.mesh));
    plant.columns.add("organs.sky", std::move(of_organs));
  }
  columns.add("segment", std::move(stems.segment));
  plant.meshes.push_back({"stems", std::string(habit.material), std::move(stems.mesh), {}, std::move(columns)});
}

}  // namespace panicle::particles
