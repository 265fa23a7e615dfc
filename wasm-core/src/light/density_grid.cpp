#include "light/density_grid.hpp"

namespace panicle {
namespace {

constexpr float max_along = 4096;

// The number of cells along a length; 1 where that is not finite or at least `max_along`.
std::int32_t cells_along(float length, float edge) {
  const float cells = length / edge;
  return cells >= 0 && cells < max_along ? static_cast<std::int32_t>(cells) + 1 : 1;
}

// The cell at `place`, in cells from the first: the nearest of the `count` cells, the first where it is not a number.
std::int32_t cell_of(float place, std::int32_t count) {
  if (!(place > 0)) return 0;
  return place < static_cast<float>(count) ? static_cast<std::int32_t>(place) : count - 1;
}

}  // namespace

// An empty grid of cells of width `edge` over the box from `low` to `high`.
DensityGrid::DensityGrid(const glm::vec3& low, const glm::vec3& high, float edge)
    : low_(low),
      edge_(edge),
      per_volume_(1 / (edge * edge * edge)),
      count_(cells_along(high.x - low.x, edge), cells_along(high.y - low.y, edge), cells_along(high.z - low.z, edge)),
      matter_(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
              static_cast<std::size_t>(count_.z)) {}

// Adds an opaque area at a place to its cell, as area per volume.
void DensityGrid::put(const glm::vec3& place, float area) {
  const glm::vec3 cells = (place - low_) / edge_;
  const glm::ivec3 at(cell_of(cells.x, count_.x), cell_of(cells.y, count_.y), cell_of(cells.z, count_.z));
  matter_[static_cast<std::size_t>((at.z * count_.y + at.y) * count_.x + at.x)] += area * per_volume_;
}

// The light in all cells, from the given directions.
VoxelLight DensityGrid::light(std::span<const LightDirection> lamps) const {
  const auto words = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  return {low_, edge_, words(count_.x), words(count_.y), words(count_.z), matter_, lamps};
}

}  // namespace panicle
