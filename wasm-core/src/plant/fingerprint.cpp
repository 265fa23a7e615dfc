#include "plant/fingerprint.hpp"

#include <span>

#include "foundation/fingerprint.hpp"

namespace panicle {

// A hash of all numbers of the meshes.
std::uint64_t mesh_fingerprint_of(const Plant& plant) {
  Fingerprint print;
  for (const PlantMesh& each : plant.meshes) {
    print.add(std::span<const float>(each.mesh.positions));
    print.add(std::span<const float>(each.mesh.normals));
    print.add(std::span<const float>(each.mesh.uvs));
    print.add(std::span<const std::uint32_t>(each.mesh.indices));
  }
  return print.value();
}

// A hash of all numbers of segments and organs.
std::uint64_t fingerprint_of(const Plant& plant) {
  Fingerprint print;
  const auto add = [&print](const glm::vec3& p) {
    print.add(p.x);
    print.add(p.y);
    print.add(p.z);
  };
  for (const Segment& segment : plant.segments) {
    print.add(static_cast<float>(segment.parent));
    print.add(static_cast<float>(segment.tag));
    add(segment.start);
    add(segment.end);
    print.add(segment.radius);
    print.add(segment.radius_end);
  }
  for (const Organ& organ : plant.organs) {
    print.add(static_cast<float>(organ.tag));
    print.add(static_cast<float>(organ.segment));
    add(organ.position);
    for (int k = 0; k < 4; ++k) print.add(organ.rotation[k]);
    print.add(organ.scale);
  }
  return print.value();
}

// Stores both fingerprints in the plant; that of the meshes if requested.
void set_fingerprints(Plant& plant, bool of_meshes) {
  plant.fingerprint = fingerprint_of(plant);
  if (of_meshes) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
}

}  // namespace panicle
