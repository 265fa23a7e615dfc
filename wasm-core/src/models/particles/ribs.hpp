// The ribs that a leaf's veins run to: built before the particles run, because particles alone make no midrib with side
// veins.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::particles {

// A tree of straight pieces. Place 0 is at the petiole; every other leads to an earlier one.
struct Ribs {
  std::vector<glm::vec3> places;
  std::vector<std::int32_t> next;  // −1 for place 0

  // A place on them: `along` from place `at` towards the next, 0 … 1.
  struct Foot {
    std::size_t at;
    float along;
    glm::vec3 place;
    float distance;  // from the queried place
  };
  // The place nearest to `p` on the piece from place `at`, not 0, to the next; and place 0.
  Foot foot_on(std::size_t at, const glm::vec3& p) const {
    const glm::vec3 from = places[at], way = places[static_cast<std::size_t>(next[at])] - from;
    const float along = share_along(way, p - from);
    const glm::vec3 place = from + along * way;
    return {at, along, place, glm::distance(p, place)};
  }
  // The square of its distance, for finding the nearest.
  float square_to(std::size_t at, const glm::vec3& p) const {
    const glm::vec3 from = places[at], way = places[static_cast<std::size_t>(next[at])] - from;
    const glm::vec3 off = p - from - share_along(way, p - from) * way;
    return glm::dot(off, off);
  }
  Foot at_base(const glm::vec3& p) const;
  // The place nearest to `p`; of equally near ones that of the earliest piece. Of ribs without a piece, place 0.
  Foot nearest(const glm::vec3& p) const;
  // The nearest on the given pieces alone, in ascending order, or place 0.
  Foot nearest(const glm::vec3& p, std::span<const std::uint32_t> pieces) const;
  // The point reached by following the ribs down by a length; place 0 at the end.
  glm::vec3 down(const Foot& from, float length) const;
  // Places all along them, no farther apart than `spacing`; place 0 first.
  std::vector<glm::vec3> sampled(float spacing) const;
  // The length from there down to place 0.
  float length_below(const Foot& from) const;

 private:
  template <class Piece>
  Foot nearest_of(std::size_t count, const Piece& piece, const glm::vec3& p) const;
  // The share, 0 … 1, of the vector `way` at which it is nearest to `p`.
  static float share_along(const glm::vec3& way, const glm::vec3& p) {
    const float square = glm::dot(way, way);
    return square > 0 ? glm::clamp(glm::dot(p, way) / square, 0.0f, 1.0f) : 0;
  }
};

}  // namespace panicle::particles
