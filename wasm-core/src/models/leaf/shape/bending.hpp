// How a flat leaf bends: folded along its midrib, waved along its margin, curled from base to tip.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::particles::leaf {

struct Bending {
  float scale = 0.09f;      // metres to a leaf length
  float half_width = 0.3f;  // leaf lengths
  float fold = 0;           // degrees that each half is raised by
  float curl = 0;           // degrees that the tip is turned down by, along a leaf length
  float undulation = 0;     // of the half width
  float waves = 4;          // along a leaf length

  // The point in space, in metres, of a place of the chart (leaf lengths), `above` metres over the blade.
  glm::vec3 operator()(const glm::vec2& p, float above = 0) const;
  // The upper side's normal there; unit.
  glm::vec3 normal(const glm::vec2& p) const;

 private:
  // A point of the bent mid-surface, metres. `folded`: sine and cosine of the angle `fold`.
  glm::vec3 sheet(const glm::vec2& p, const SinCos& folded) const;
};

}  // namespace panicle::particles::leaf
