#include "stems/tubes.hpp"

#include <algorithm>

#include "stems/root_flare.hpp"
#include "stems/stem_axes.hpp"
#include "stems/stem_rings.hpp"
#include "stems/tube_writer.hpp"

namespace panicle {

// Sweeps tubes along all axes of stems, with as many sides and rings as the limit of vertices allows.
StemMesh sweep_stems(const Stems& stems, const TubeOptions& options, float scale) {
  const StemAxes axes = find_stem_axes(stems);
  TubeMaker maker(stems, axes, options);
  const auto count = [&](bool thin) {
    TubeCount all;
    for (const StemAxis& axis : axes.axes) {
      if (maker.is_thin(axis) != thin) continue;
      all.rings += maker.count_rings(axis);
      ++all.tubes;
    }
    return all;
  };
  // Halves the sides, and then uses fewer rings, where there would be too many vertices.
  TubeCount thick = count(false), thin = count(true);
  std::uint32_t sides = std::clamp(options.sides, 3u, 64u), thin_sides = std::clamp(options.thin_sides, 3u, sides);
  const auto vertices = [&] { return thick.vertices(sides) + thin.vertices(thin_sides); };
  while (vertices() > options.max_vertices && sides > 3) {
    sides = std::max(sides / 2, 3u);
    thin_sides = std::min(thin_sides, sides);
  }
  if (vertices() > options.max_vertices) {
    maker.coarsen();
    thick = count(false);
    thin = count(true);
  }

  StemMesh stem;
  const RingPattern pattern(sides), thin_pattern(thin_sides);
  TubeWriter writer(stem, vertices(), 2 * (thick.rings * sides + thin.rings * thin_sides));
  Tube tube;
  std::vector<TrunkFoot> feet;
  for (const StemAxis& axis : axes.axes) {
    if (stem.parts.empty() || stem.parts.back().group != axis.group) {
      stem.parts.push_back({{writer.vertices(), 0, writer.indices(), 0}, axis.group});
    }
    const RingPattern& used = maker.is_thin(axis) ? thin_pattern : pattern;
    maker.make(axis, used.sides, tube);
    if (const RootFlare* flare = maker.flare_of(axis)) feet.push_back(take_foot(tube, *flare, used.sides));
    writer.write(tube, used, scale);
    StemPart& part = stem.parts.back();
    part.vertex_count = writer.vertices() - part.first_vertex;
    part.index_count = writer.indices() - part.first_index;
  }
  writer.finish();
  for (const TrunkFoot& foot : feet) add_root_flare(stem, foot, scale);
  return stem;
}

}  // namespace panicle
