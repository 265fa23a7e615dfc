#include "mesh/mesh.hpp"

namespace panicle {
namespace {

// Appends three numbers.
template <class Number>
void put_three(std::vector<Number>& values, Number a, Number b, Number c) {
  values.push_back(a);
  values.push_back(b);
  values.push_back(c);
}

}  // namespace

// The range of all vertices and indices.
MeshRange whole_range(const Mesh& mesh) {
  return {0, static_cast<std::uint32_t>(mesh.positions.size() / 3), 0, static_cast<std::uint32_t>(mesh.indices.size())};
}

// Appends coordinates, or the corners of a triangle, to a list.
void put(std::vector<float>& values, const glm::vec3& v) { put_three(values, v.x, v.y, v.z); }

void put(std::vector<float>& values, const glm::vec2& v) {
  values.push_back(v.x);
  values.push_back(v.y);
}

void put(std::vector<std::uint32_t>& indices, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  put_three(indices, a, b, c);
}

}  // namespace panicle
