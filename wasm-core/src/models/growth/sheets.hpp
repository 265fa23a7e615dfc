// Leaves or blossoms as rhombi, and fewer rhombi in their place, with the same area and the same extent.
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "plant/plant.hpp"

namespace panicle::growth {

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};

  // Extends the box to a point.
  void include(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  glm::vec3 size() const { return glm::max(high - low, glm::vec3(0)); }
};

// One leaf or blossom, or several merged into one.
struct Sheet {
  glm::vec3 middle{0}, along{0}, across{0};  // to its tip and across it, of length 1
  float area = 0, length = 0;                // of one side; from end to end
  bool one = true;

  // The sheet's normal, as long as its area.
  glm::vec3 face() const { return glm::cross(across, along); }
  // Its base, its two sides and its tip, from the middle.
  std::array<glm::vec3, 4> corners() const {
    const glm::vec3 tip = 0.5f * length * along, side = area / length * across;
    return {-tip, side, -side, tip};
  }
};

enum class SheetKind { leaf, blossom };  // the orientations of their meshes

class Sheets {
 public:
  Sheets() = default;
  // Sheets of the organs whose tags are from `first` to `last`; `area`: one side at scale 1.
  Sheets(std::span<const Organ> organs, std::uint32_t first, std::uint32_t last, SheetKind kind, float area);

  std::span<const Sheet> all() const { return sheets_; }
  const Box& middles() const { return middles_; }
  // Sorts sheets so that consecutive ones are mostly near each other.
  void sort();
  // After `sort`: `count` sheets, each in place of equally many consecutive ones: at their mean, with their total area
  // and the orientation of one of them. The middles are then scaled so that corners reach the edges of `target`.
  std::vector<Sheet> merged(std::size_t count, const Box& target) const;

 private:
  std::vector<Sheet> sheets_;
  Box middles_;
  float breadth_ = 0;  // width of a merged sheet, as a share of its length
};

}  // namespace panicle::growth
