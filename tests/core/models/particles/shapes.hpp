// Shapes and guides that tests of the particles share.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "models/particles/guide.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

// A disc or a ball about the origin, hollow where `hole` is above 0.
class Round final : public Region {
 public:
  Round(bool flat, float radius = 1, float hole = 0) : flat_(flat), radius_(radius), hole_(hole) {}
  glm::vec3 low() const override { return {-radius_, -radius_, flat_ ? 0 : -radius_}; }
  glm::vec3 high() const override { return -low(); }
  bool contains(const glm::vec3& p) const override {
    const float from = glm::length(p);
    return from <= radius_ && from >= hole_;
  }

 private:
  bool flat_;
  float radius_, hole_;
};

// A region with one half as dense as the other.
class Shaded final : public Region {
 public:
  glm::vec3 low() const override { return {-1, -1, 0}; }
  glm::vec3 high() const override { return {1, 1, 0}; }
  bool contains(const glm::vec3& p) const override { return std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1; }
  float density(const glm::vec3& p) const override { return p.x < 0 ? 1.0f : 0.25f; }
};

// A wall along the y axis, with a gate above y = 0.5: sees, opens and aims round it.
class Walled final : public Guide {
 public:
  using Guide::Guide;
  glm::vec3 aim(const glm::vec3& p) const override { return sees(p, target()) ? target() : glm::vec3(0, 0.55f, 0); }
  float way(const glm::vec3& p) const override { return glm::distance(p, aim(p)) + glm::distance(aim(p), target()); }
  bool open(const glm::vec3& p) const override { return std::fabs(p.x) >= 0.01f || p.y > 0.5f; }
  bool sees(const glm::vec3& a, const glm::vec3& b) const override {
    if ((a.x > 0) == (b.x > 0)) return true;
    const float at = a.x / (a.x - b.x);
    return a.y + at * (b.y - a.y) > 0.5f;
  }
};

}  // namespace panicle::particles
