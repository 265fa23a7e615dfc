#include "models/flower/fingerprint.hpp"

#include <vector>

#include "foundation/fingerprint.hpp"
#include "models/flower/units.hpp"

namespace panicle::flower {

// Computes a flower's fingerprint: a hash of its volumes, materials and vertices.
std::uint64_t fingerprint_of(const Derived& derived, const generalized_map::Embedding& embedding) {
  const generalized_map::Map& map = derived.map;
  Fingerprint print;
  const auto add = [&print](std::uint32_t number) {
    print.add(number == generalized_map::none ? -1.0f : static_cast<float>(number));
  };
  // Labels are numbered by first use: renaming a volume does not change the fingerprint.
  std::vector<std::uint32_t> place_of;
  std::uint32_t mentioned = 0;
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    const generalized_map::Volume& volume = map.volume(v);
    if (volume.label >= place_of.size()) place_of.resize(volume.label + 1, generalized_map::none);
    std::uint32_t& place = place_of[volume.label];
    if (place == generalized_map::none) place = mentioned++;
    add(place);
    add(volume.order);
    add(volume.parent);
    print.add(derived.values[derived.record_of[v]][static_cast<std::size_t>(Field::material)]);
  }
  for (const glm::vec3& each : embedding.positions()) {
    const glm::vec3 at = metres * y_up(each);
    print.add(at.x);
    print.add(at.y);
    print.add(at.z);
  }
  return print.value();
}

}  // namespace panicle::flower
