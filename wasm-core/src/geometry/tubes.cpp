#include "geometry/tubes.hpp"

#include <algorithm>

#include "geometry/stem_axes.hpp"
#include "geometry/stem_rings.hpp"
#include "geometry/tube_writer.hpp"

namespace panicle {

StemMesh sweep_stems(const Stems& stems, const TubeOptions& options, float scale) {
  const StemAxes axes = find_stem_axes(stems);
  TubeMaker maker(stems, axes);
  const auto count_rings = [&] {
    std::uint64_t rings = 0;
    for (const StemAxis& axis : axes.axes) rings += maker.count_rings(axis);
    return rings;
  };
  std::uint64_t rings = count_rings();
  std::uint32_t sides = std::clamp(options.sides, 3u, 64u);
  const auto too_many = [&] {
    return TubeWriter::vertices_for(sides, rings, axes.axes.size()) > options.most_vertices;
  };
  while (too_many() && sides > 3) sides = std::max(sides / 2, 3u);
  if (too_many()) {
    maker.coarsen();
    rings = count_rings();
  }

  StemMesh stem;
  TubeWriter writer(stem, sides, rings, axes.axes.size());
  Tube tube;
  for (const StemAxis& axis : axes.axes) {
    if (stem.parts.empty() || stem.parts.back().group != axis.group) {
      stem.parts.push_back({axis.group, writer.vertices(), 0, writer.indices(), 0});
    }
    maker.make(axis, tube);
    writer.write(tube, scale);
    StemPart& part = stem.parts.back();
    part.vertex_count = writer.vertices() - part.first_vertex;
    part.index_count = writer.indices() - part.first_index;
  }
  writer.finish();
  return stem;
}

}  // namespace panicle
