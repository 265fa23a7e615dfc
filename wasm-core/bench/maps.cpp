#include "maps.hpp"

#include <vector>

#include "generalized_map/check.hpp"
#include "generalized_map/embedding.hpp"
#include "generalized_map/map.hpp"

namespace panicle::bench {
namespace {

using namespace generalized_map;

constexpr std::uint32_t vein_order = 8, lobe_order = 4;
constexpr std::uint32_t lobe_sides[] = {2, 3, 4, 6, 7, 8};
constexpr std::uint32_t darts_a_step = prism_darts(vein_order) + 6 * prism_darts(lobe_order);

Map vein(std::uint32_t darts) {
  const std::uint32_t steps = darts / darts_a_step + 1;
  Map map;
  map.reserve(steps * darts_a_step, steps * 7);
  std::uint32_t tip = map.plant(vein_order, 0).volume;
  for (std::uint32_t step = 0; step < steps; ++step) {
    if (step > 0) tip = map.grow(tip, end_face, vein_order, 0).volume;
    for (const std::uint32_t i : lobe_sides) {
      const std::uint32_t lobe = map.grow(tip, side(i), lobe_order, i).volume;
      // A step has seven volumes: the lobe of the step before (7 numbers less) has its tipward face at this lobe's
      // baseward face.
      if (step > 0) map.glue(lobe, side(1), lobe - 7, side(3));
    }
  }
  return map;
}

struct BuiltMap {
  Map map;
  Embedding embedding;
  std::vector<Shape> shapes;
};

BuiltMap& built(std::uint32_t darts) {
  static BuiltMap cached;
  static std::uint32_t of = 0;
  if (of != darts) {
    cached.map = vein(darts);
    cached.embedding.build(cached.map);
    cached.shapes.assign(cached.map.volumes(), Shape{1, 0, 0, 1, 1, 1});
    of = darts;
  }
  return cached;
}

}  // namespace

double build_map(std::uint32_t darts) { return vein(darts).darts(); }

double check_map(std::uint32_t darts) {
  const Map& map = built(darts).map;
  return check(map).fault == Fault::nothing ? map.darts() : -1;
}

double embed_map(std::uint32_t darts) {
  BuiltMap& cached = built(darts);
  cached.embedding.build(cached.map);
  return cached.map.darts();
}

double place_map(std::uint32_t darts) {
  BuiltMap& cached = built(darts);
  cached.embedding.place(cached.shapes);
  return cached.map.darts();
}

}  // namespace panicle::bench
