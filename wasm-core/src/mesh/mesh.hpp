// A triangle mesh as flat arrays, the format of responses: counter-clockwise triangles, unit normals.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle {

struct Mesh {
  std::vector<float> positions;        // 3 × vertices
  std::vector<float> normals;          // 3 × vertices
  std::vector<float> uvs;              // 2 × vertices
  std::vector<std::uint32_t> indices;  // 3 × triangles
};

// A contiguous part of a mesh's arrays.
struct MeshRange {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_index = 0, index_count = 0;  // indices count from the whole mesh's first vertex
};

// The range of a whole mesh.
MeshRange whole_range(const Mesh& mesh);

// Append coordinates, or a triangle: in wasm a few push_back calls are several times as fast as an insert.
void put(std::vector<float>& values, const glm::vec3& v);
void put(std::vector<float>& values, const glm::vec2& v);
void put(std::vector<std::uint32_t>& indices, std::uint32_t a, std::uint32_t b, std::uint32_t c);

}  // namespace panicle
