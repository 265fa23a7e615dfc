#include "protocol/answer.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/container.hpp"

namespace panicle {
namespace {

using Words = std::vector<std::uint32_t>;

// Names as text, a line each.
template <class Names>
std::string lines(const Names& names) {
  std::string text;
  for (const auto& name : names) text.append(text.empty() ? "" : "\n").append(name);
  return text;
}

// The lower and the upper 32 bits.
std::array<std::uint32_t, 2> halves(std::uint64_t value) {
  return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)};
}

constexpr std::uint64_t large = 1 << 14;  // bytes that are worth leaving where they are

// Adds the columns of all segments.
void add_segments(Columns& columns, const std::vector<Segment>& segments) {
  columns.add("segments.parent", column_of<std::int32_t>(segments, 1, [](const Segment& segment, std::int32_t* at) {
                *at = segment.parent;
              }));
  columns.add("segments.tag", column_of<std::uint32_t>(
                                  segments, 1, [](const Segment& segment, std::uint32_t* at) { *at = segment.tag; }));
  columns.add("segments.ends",
              column_of<float>(segments, 6,
                               [](const Segment& segment, float* at) {
                                 put(segment.start, at);
                                 put(segment.end, at + 3);
                               }),
              6);
  columns.add("segments.radii",
              column_of<float>(segments, 2,
                               [](const Segment& segment, float* at) {
                                 at[0] = segment.radius;
                                 at[1] = segment.radius_end;
                               }),
              2);
}

// Adds the columns of all organs. A transform is the position, the rotation as a quaternion x y z w, and the scale.
void add_organs(Columns& columns, const std::vector<Organ>& organs) {
  columns.add("organs.tag",
              column_of<std::uint32_t>(organs, 1, [](const Organ& organ, std::uint32_t* at) { *at = organ.tag; }));
  columns.add("organs.segment",
              column_of<std::int32_t>(organs, 1, [](const Organ& organ, std::int32_t* at) { *at = organ.segment; }));
  columns.add("organs.mesh",
              column_of<std::int32_t>(organs, 1, [](const Organ& organ, std::int32_t* at) { *at = organ.mesh; }));
  columns.add("organs.transforms",
              column_of<float>(organs, 8,
                               [](const Organ& organ, float* at) {
                                 put(organ.position, at);
                                 for (int k = 0; k < 4; ++k) at[3 + k] = organ.rotation[k];
                                 at[7] = organ.scale;
                               }),
              8);
}

// Adds the columns of a mesh's runs: ranges of vertices and indices, and names, a line each.
void add_runs(Columns& columns, const std::vector<MeshRun>& runs) {
  std::string names;
  for (const MeshRun& run : runs) names.append(names.empty() ? "" : "\n").append(run.name);
  columns.add("runs",
              column_of<std::uint32_t>(runs, 4,
                                       [](const MeshRun& run, std::uint32_t* at) {
                                         at[0] = run.first_vertex;
                                         at[1] = run.vertex_count;
                                         at[2] = run.first_index;
                                         at[3] = run.index_count;
                                       }),
              4);
  columns.add("runs.names", std::string_view(names));
}

// Adds columns with a prefix before their names.
void add_columns(ContainerWriter& out, const std::string& prefix, const Columns& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) out.add(prefix + std::string(columns[i].name), columns[i]);
}

// Adds the columns of a mesh.
void add_mesh(ContainerWriter& out, const PlantMesh& mesh) {
  const std::string prefix = "mesh." + mesh.name + ".";
  out.add(prefix + "material", std::string_view(mesh.material));
  out.add(prefix + "positions", mesh.mesh.positions, 3);
  out.add(prefix + "normals", mesh.mesh.normals, 3);
  out.add(prefix + "uvs", mesh.mesh.uvs, 2);
  out.add(prefix + "indices", mesh.mesh.indices, 3);
  add_columns(out, prefix, mesh.columns);
}

}  // namespace

// Writes the response for a plant. In wasm, large arrays are not copied.
std::uint8_t* write_plant(Plant& plant) {
  ContainerWriter out;
  const std::array<std::uint32_t, 3> status{};
  // Large arrays of the plant are referred to; arrays that are made here are copied.
  out.copy("status", std::span<const std::uint32_t>(status));
  out.copy("notes", lines(plant.notes));
  out.copy("fingerprint", std::span<const std::uint32_t>(halves(plant.fingerprint)));
  if (plant.cut_short != CutShort::none) out.copy("cut_short", Words{static_cast<std::uint32_t>(plant.cut_short)});
  if (plant.mesh_fingerprint != 0)
    out.copy("mesh_fingerprint", std::span<const std::uint32_t>(halves(plant.mesh_fingerprint)));

  std::string count_names;
  Words counts;
  for (const Count& count : plant.counts) {
    count_names.append(count_names.empty() ? "" : "\n").append(count.name);
    counts.push_back(count.value);
  }
  out.copy("counts", counts);
  out.copy("counts.names", count_names);
  if (!plant.measures.empty()) out.add("measures", plant.measures);

  add_segments(plant.columns, plant.segments);
  out.copy("segments.tags", lines(plant.tags));
  if (!plant.organs.empty()) {
    add_organs(plant.columns, plant.organs);
    out.copy("organs.tags", lines(plant.organ_tags));
  }
  std::string mesh_names;
  for (PlantMesh& mesh : plant.meshes) {
    mesh_names.append(mesh_names.empty() ? "" : "\n").append(mesh.name);
    if (!mesh.runs.empty()) add_runs(mesh.columns, mesh.runs);
    add_mesh(out, mesh);
  }
  out.copy("meshes", mesh_names);
  add_columns(out, "", plant.columns);
  return sizeof(void*) == 4 ? out.write(large) : out.write();
}

// Writes the response for a compiled text.
std::uint8_t* write_program(std::uint32_t handle) {
  ContainerWriter out;
  const std::array<std::uint32_t, 3> status{};
  out.add("status", std::span<const std::uint32_t>(status));
  out.add("program", std::span<const std::uint32_t>(&handle, 1));
  return out.write();
}

// Writes the response for an error: its reason, place and message.
std::uint8_t* write_failure(const Diagnostic& diagnostic) {
  ContainerWriter out;
  const std::array<std::uint32_t, 3> status{static_cast<std::uint32_t>(diagnostic.reason), diagnostic.line,
                                            diagnostic.column};
  out.add("status", std::span<const std::uint32_t>(status));
  out.add("message", std::string_view(diagnostic.message));
  return out.write();
}

}  // namespace panicle
