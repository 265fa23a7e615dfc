// Points and vectors in flat arrays of three numbers each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle {

// The vector in row `row` of a list of coordinates.
inline glm::vec3 vector_at(std::span<const float> values, std::size_t row) {
  return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

// All vectors of an array; without the one or two numbers that may be left over.
inline std::vector<glm::vec3> vectors_of(std::span<const float> values) {
  std::vector<glm::vec3> vectors(values.size() / 3);
  for (std::size_t row = 0; row < vectors.size(); ++row) vectors[row] = vector_at(values, row);
  return vectors;
}

// The limit of lengths and coordinates in requests: 10 km, in metres.
inline constexpr float max_coordinate = 1e4f;

// False for numbers that are not finite.
inline bool is_coordinate(float value) { return std::fabs(value) <= max_coordinate; }

// Whether all numbers may be coordinates: finite, and not too large.
inline bool are_coordinates(std::span<const float> values) {
  return std::all_of(values.begin(), values.end(), is_coordinate);
}

}  // namespace panicle
