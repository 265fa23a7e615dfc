// Leaves or blossoms as rhombi, and fewer of them that stand for all: of the same area, reaching as far.
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

  void hold(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  glm::vec3 size() const { return glm::max(high - low, glm::vec3(0)); }
};

// One, or several as one.
struct Sheet {
  glm::vec3 middle{0}, along{0}, across{0};  // to its tip and across it, of length 1
  float area = 0, length = 0;                // of one side; from end to end
  bool one = true;

  glm::vec3 face() const { return glm::cross(across, along); }
  // Its foot, the two beside it, and its tip, from the middle.
  std::array<glm::vec3, 4> corners() const {
    const glm::vec3 tip = 0.5f * length * along, side = area / length * across;
    return {-tip, side, -side, tip};
  }
};

enum class SheetKind { leaf, blossom };  // the ways in which their meshes lie

class Sheets {
 public:
  Sheets() = default;
  // Of organs whose tags lie from `first` to `last`; `area`: one side of one of scale 1.
  Sheets(std::span<const Organ> organs, std::uint32_t first, std::uint32_t last, SheetKind kind, float area);

  std::span<const Sheet> all() const { return sheets_; }
  const Box& middles() const { return middles_; }
  // Brings near ones side by side, mostly.
  void sort();
  // Once they are sorted: so many, each in the place of as many that stand side by side: in their middle, with the area
  // of them all, turned as one of them. Middles lie within the outline of what they are of, and so they are moved apart
  // to reach `target`.
  std::vector<Sheet> merged(std::size_t count, const Box& target) const;

 private:
  std::vector<Sheet> sheets_;
  Box middles_;
  float breadth_ = 0;  // of one that several have become, of its length
};

}  // namespace panicle::growth
