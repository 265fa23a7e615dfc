// The result of every model, in metres, +Y up. Additional data of a model are columns by name.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foundation/container.hpp"
#include "foundation/work_budget.hpp"
#include "mesh/mesh.hpp"
#include "stems/segment.hpp"

namespace panicle {

// Named arrays of any element type that own their values.
class Columns {
 public:
  template <class Value>
  void add(std::string_view name, std::vector<Value> values, std::uint32_t width = 1) {
    share(name, std::make_shared<const std::vector<Value>>(std::move(values)), width);
  }
  // Adds values with shared ownership.
  template <class Value>
  void share(std::string_view name, std::shared_ptr<const std::vector<Value>> values, std::uint32_t width = 1) {
    const std::span<const Value> all(*values);
    keep({name, element_of<Value>(), width, static_cast<std::uint32_t>(all.size() / width),
          reinterpret_cast<const std::uint8_t*>(all.data())},
         std::move(values));
  }
  // Adds a text.
  void add(std::string_view name, std::string_view text);

  std::size_t size() const { return all_.size(); }
  ColumnView operator[](std::size_t i) const {
    const Column& column = all_[i];
    return {column.name, column.element, column.width, column.rows, column.data};
  }

 private:
  struct Column {
    std::string name;
    Element element;
    std::uint32_t width, rows;
    const std::uint8_t* data;
    std::shared_ptr<const void> owner;
  };
  void keep(const ColumnView& view, std::shared_ptr<const void> owner);

  std::vector<Column> all_;
};

// Makes a column from the rows of other data: `write(row, values)` sets the values of one row.
template <class Value, class Rows, class Write>
std::vector<Value> column_of(const Rows& rows, std::uint32_t width, Write write) {
  std::vector<Value> values(rows.size() * width);
  Value* at = values.data();
  for (const auto& row : rows) {
    write(row, at);
    at += width;
  }
  return values;
}

// Writes the coordinates of a point to at[0 … 2].
inline void put(const glm::vec3& point, float* at) {
  at[0] = point.x;
  at[1] = point.y;
  at[2] = point.z;
}

// An attached organ such as a leaf or a fruit. Organs share meshes.
struct Organ {
  std::uint32_t tag = 0;      // index into Plant::organ_tags
  std::int32_t segment = -1;  // parent segment; −1 for none
  std::int32_t mesh = -1;     // index into Plant::meshes; −1 for an organ without a mesh
  glm::vec3 position{0};
  glm::vec4 rotation{0, 0, 0, 1};  // unit quaternion x y z w: from the mesh's frame to where it stands
  float scale = 1;
};

// A named part of a mesh.
struct MeshRun : MeshRange {
  std::string name;
};

struct PlantMesh {
  std::string name;
  std::string material;  // its kind: stem, bark, blade, petal, skin …
  Mesh mesh;
  std::vector<MeshRun> runs;  // empty: the mesh is one thing
  Columns columns;            // additional data of its vertices or runs
};

struct Count {
  std::string_view name;  // as the JSON writes it
  std::uint32_t value = 0;
};

// The reason why a plant's growth ended early. The numbers cross the boundary (exports/panicle.h).
enum class CutShort : std::uint32_t {
  none = 0,
  limit = 1,  // a limit of the core
  time = 2,   // the time limit of the host
};

// The reason for a plant that has reached a limit.
inline CutShort cut_short_by(const WorkBudget& budget) {
  return budget.time_has_ended_work() ? CutShort::time : CutShort::limit;
}

struct Plant {
  std::vector<Segment> segments;  // one a drawn module, parents first
  std::vector<std::string> tags;  // kinds of segments
  std::vector<Organ> organs;
  std::vector<std::string> organ_tags;
  std::vector<PlantMesh> meshes;  // the requested ones
  Columns columns;                // the model's own truth
  std::vector<Count> counts;
  std::vector<float> measures;     // in the order of the model's table; NaN: does not apply; empty: not requested
  std::vector<std::string> notes;  // remarks on the request, one sentence each
  CutShort cut_short = CutShort::none;
  std::uint64_t fingerprint = 0;       // over segments and organs (docs/fingerprint.md)
  std::uint64_t mesh_fingerprint = 0;  // over the meshes; 0 where it was not requested
};

}  // namespace panicle
