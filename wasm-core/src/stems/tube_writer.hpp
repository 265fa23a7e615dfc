// Writes tubes to the arrays of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "stems/stem_rings.hpp"
#include "stems/tubes.hpp"

namespace panicle {

// Precomputed data of all rings with one number of sides.
struct RingPattern {
  explicit RingPattern(std::uint32_t sides_);

  std::uint32_t sides, padded;                    // and rounded up to a multiple of four
  std::vector<float> cosine, sine;                // of the sides' angles
  std::vector<float> cosine_thrice, sine_thrice;  // each for x, y and z
  std::vector<float> u;                           // u and 0 for each vertex of a ring
  std::vector<std::uint32_t> band;  // indices between a ring and the next, the ring's first vertex being 0
};

// The numbers of rings and tubes with a pattern.
struct TubeCount {
  std::uint64_t rings = 0, tubes = 0;

  // The number of vertices of tubes with so many sides: rings with a seam, and two poles for each tube.
  std::uint64_t vertices(std::uint32_t sides) const { return rings * (sides + 1) + tubes * 2; }
};

// Writes tubes one after the other. Arrays have a few elements too many at first, since writes are four at a time.
class TubeWriter {
 public:
  // Reserves space in `stem`, which must outlive the writer, for that many vertices and triangles.
  TubeWriter(StemMesh& stem, std::uint64_t vertices, std::uint64_t triangles);

  // Appends a tube, its positions scaled. The pattern must outlive the call.
  void write(const Tube& tube, const RingPattern& pattern, float scale);
  // Frees unused memory. Call it last.
  void finish();

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t indices() const { return indices_; }

 private:
  void write_pole(const glm::vec3& position, const glm::vec3& normal, const Ring& ring);
  void write_collar(const Collar& collar, float scale);
  void write_ring(const Tube& tube, const Ring& ring, float scale);
  void write_ellipse(float* out, const glm::vec3& centre, const glm::vec3& right, const glm::vec3& forward) const;
  void write_normals(const Tube& tube, const Ring& ring, float* out) const;
  void write_triangles(std::uint32_t first_pole, std::uint32_t rings);

  StemMesh& stem_;
  const RingPattern* pattern_ = nullptr;  // of the tube being written
  std::uint32_t vertices_ = 0, indices_ = 0;
};

}  // namespace panicle
