#include "environment/matter_cells.hpp"

#include <glm/common.hpp>

namespace panicle {

MatterCells::MatterCells(const glm::vec3& low, const glm::vec3& high, float edge)
    : low_(low),
      edge_(edge),
      per_volume_(1 / (edge * edge * edge)),
      count_(glm::ivec3((high - low) / edge) + 1),
      matter_(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
              static_cast<std::size_t>(count_.z)) {}

void MatterCells::put(const glm::vec3& place, float area) {
  const glm::ivec3 at = glm::clamp(glm::ivec3((place - low_) / edge_), glm::ivec3(0), count_ - 1);
  matter_[static_cast<std::size_t>((at.z * count_.y + at.y) * count_.x + at.x)] += area * per_volume_;
}

VoxelLight MatterCells::light(std::span<const Lamp> lamps) const {
  const auto words = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  return {low_, edge_, words(count_.x), words(count_.y), words(count_.z), matter_, lamps};
}

}  // namespace panicle
