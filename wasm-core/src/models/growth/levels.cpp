#include "models/growth/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/rotation.hpp"
#include "light/sky_visibility.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/sheets.hpp"

namespace panicle::growth {
namespace {

constexpr std::array<const char*, level_count> names{"level0", "level1", "level2", "level3"};
// Triangles fall by at least this factor a level; the last level has at most `max_far`.
constexpr float falls_by = 2.6f, max_far = 144;
// The share of the first level's wood that is left in each level, on top of the general fall: from afar leaves matter
// more.
constexpr std::array<float, level_count> wood_share{1, 0.9f, 0.75f, 0.6f};
// Tolerance of shoots' centre lines, as a share of the tree's height.
constexpr std::array<float, level_count> bend{0.0008f, 0.004f, 0.012f, 0.04f};
// Sides of a shoot by its thickness over the thickest: bounds of the classes.
constexpr std::array<float, 2> shares{0.5f, 0.18f};
constexpr std::array<std::array<std::uint32_t, 3>, level_count> sides_of{
    {{{8, 5, 3}}, {{5, 4, 3}}, {{4, 3, 3}}, {{3, 3, 3}}}};
constexpr std::uint32_t max_sides = 8;
constexpr float folded = 20;    // degrees that each half of a leaf is folded up
constexpr float sparse = 0.8f;  // leaves that reach less far than this share of the tree do not cover its outline
constexpr float sky_cells = 7;
constexpr std::uint32_t sky_directions = 6;
constexpr std::size_t min_cover = 8;  // fewer sheets do not cover the outline

// The box of vertices x, y, z: four vertices are three vectors of four floats.
Box box_of(std::span<const float> vertices) {
  constexpr std::size_t block = 12;
  Box box;
  const std::size_t blocks_end = vertices.size() / block * block;
  if (blocks_end > 0) {
    std::array<Four, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) low[k] = high[k] = load(&vertices[4 * k]);
    for (std::size_t i = block; i < blocks_end; i += block)
      for (std::size_t k = 0; k < 3; ++k) {
        const Four values = load(&vertices[i + 4 * k]);
        low[k] = values < low[k] ? values : low[k];
        high[k] = values > high[k] ? values : high[k];
      }
    const auto component = [](const std::array<Four, 3>& fours, std::size_t i) {
      return fours[i / 4][static_cast<int>(i % 4)];
    };
    for (std::size_t i = 0; i < block; i += 3) {
      box.include({component(low, i), component(low, i + 1), component(low, i + 2)});
      box.include({component(high, i), component(high, i + 1), component(high, i + 2)});
    }
  }
  for (std::size_t i = blocks_end; i < vertices.size(); i += 3)
    box.include({vertices[i], vertices[i + 1], vertices[i + 2]});
  return box;
}

// The consecutive segments of one shoot: the index of the first, and their number.
struct Run {
  std::uint32_t first = 0, count = 0;
};

// Leaves or blossoms, one run in each level.
struct SheetGroup {
  const char* name;
  Sheets sheets;
  Box reach = {};  // of all corners in the first level
};

// Builder of a tree's levels of detail: meshes with fewer and fewer triangles, each with one run of triangles for bark,
// leaves and blossoms.
class LevelBuilder {
 public:
  LevelBuilder(const Moment& moment, std::span<const Organ> organs, float leaf_area, float blossom_area)
      : moment_(moment),
        groups_{{{"leaves", {organs, leaf_tag, falling_tag, SheetKind::leaf, leaf_area}},
                 {"blossoms", {organs, blossom_tag, blossom_tag, SheetKind::blossom, blossom_area}}}},
        visibility_(visibility_of(moment, groups_)) {
    for (std::uint32_t n = 3; n <= max_sides; ++n)
      for (std::uint32_t k = 0; k < n; ++k)
        turns_[n][k] = sincos_degrees(360 * static_cast<float>(k) / static_cast<float>(n));
    collect_shoots();
    for (const SheetGroup& group : groups_) leafy_ |= covers_outline(group.sheets);
  }

  // Builds the first `count` levels, the finest first.
  TreeLevels run(std::size_t count) {
    made_.meshes.resize(count);
    made_.tolerance.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      if (k == 1)
        for (SheetGroup& group : groups_) group.sheets.sort();
      build_level(k);
    }
    return std::move(made_);
  }

 private:
  // Computes how much sky is visible, with wood and sheets (leaves and blossoms) as occluders.
  static SkyVisibility visibility_of(const Moment& moment, std::span<const SheetGroup> groups) {
    std::vector<Occluder> occluders;
    std::size_t count = 0;
    for (const SheetGroup& group : groups) count += group.sheets.all().size();
    occluders.reserve(count);
    for (const SheetGroup& group : groups)
      for (const Sheet& sheet : group.sheets.all()) occluders.push_back({sheet.middle, 0.5f * sheet.area});
    return {moment.segments, occluders, sky_cells, sky_directions};
  }

  // Sorts shoots, thickest first: parents come before their children.
  void collect_shoots() {
    const auto count = static_cast<std::uint32_t>(moment_.segments.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i == 0 || moment_.axes[i] != moment_.axes[i - 1]) shoots_.push_back({i, 0});
      ++shoots_.back().count;
      tree_box_.include(moment_.segments[i].start);
      tree_box_.include(moment_.segments[i].end);
    }
    std::sort(shoots_.begin(), shoots_.end(), [&](const Run& a, const Run& b) {
      const float radius_a = moment_.segments[a.first].radius, radius_b = moment_.segments[b.first].radius;
      return radius_a != radius_b ? radius_a > radius_b : a.first < b.first;
    });
    height_ = shoots_.empty() ? 0 : std::max(tree_box_.high.y - tree_box_.low.y, 1e-3f);
  }

  // Whether the sheets are enough and reach far enough to hide the ends of the wood.
  bool covers_outline(const Sheets& sheets) const {
    const glm::vec3 crown = sheets.middles().size(), tree_size = tree_box_.size();
    return sheets.all().size() >= min_cover && crown.x > sparse * tree_size.x && crown.z > sparse * tree_size.z &&
           sheets.middles().high.y > sparse * tree_box_.high.y;
  }

  // Builds the mesh of one level: the wood within its budget of triangles, then sheets; in coarse levels several are
  // merged into one.
  void build_level(std::size_t level) {
    PlantMesh& out = made_.meshes[level];
    out.name = names[level];
    out.material = "level";
    out_ = &out;
    mesh_ = &out.mesh;
    const float share = leafy_ ? wood_share[level] : 1;
    add_wood(level, level == 0 ? 0 : share * static_cast<float>(first_wood_) / fall(level));
    end_run("bark");
    if (level == 0) {
      first_wood_ = triangles();
      for (SheetGroup& group : groups_) {
        append_room(4 * group.sheets.all().size(), 2 * group.sheets.all().size());
        const std::span<const Sheet> all = group.sheets.all();
        const std::vector<std::uint8_t> sky = sky_of(all);
        for (std::size_t i = 0; i < all.size(); ++i) add_folded(all[i], sky[i]);
        end_run(group.name);
      }
      first_all_ = triangles();
      if (made_.meshes.size() > 1) find_reaches(out.runs);
    } else {
      const float triangles_left = static_cast<float>(first_all_) / fall(level) - static_cast<float>(triangles());
      for (const SheetGroup& group : groups_) {
        add_merged(level, group, triangles_left);
        end_run(group.name);
      }
    }
    out.columns.add("sky", std::move(sky_));
    sky_ = {};
  }

  // The number of all leaves and blossoms.
  std::size_t sheet_count() const {
    std::size_t count = 0;
    for (const SheetGroup& group : groups_) count += group.sheets.all().size();
    return count;
  }

  // The number of triangles in the current mesh.
  std::size_t triangles() const { return mesh_->indices.size() / 3; }

  // Ends a run of the mesh: all vertices and triangles since the last one get this name.
  void end_run(const char* name) {
    std::vector<MeshRun>& runs = out_->runs;
    const MeshRun last = runs.empty() ? MeshRun{} : runs.back();
    const std::uint32_t vertex = last.first_vertex + last.vertex_count, index = last.first_index + last.index_count;
    runs.push_back({{vertex, static_cast<std::uint32_t>(sky_.size()) - vertex, index,
                     static_cast<std::uint32_t>(mesh_->indices.size()) - index},
                    name});
  }

  // Boxes of the first level and of its groups, whose runs come after the bark's: later levels reach as far.
  void find_reaches(std::span<const MeshRun> runs) {
    first_level_box_ = box_of(mesh_->positions);
    for (std::size_t i = 0; i < groups_.size(); ++i) groups_[i].reach = box_of(vertices_of(runs[i + 1]));
  }

  // The coordinates of a run's vertices.
  std::span<const float> vertices_of(const MeshRun& run) const {
    return std::span(mesh_->positions).subspan(3 * std::size_t{run.first_vertex}, 3 * std::size_t{run.vertex_count});
  }

  // The factor by which a level has fewer triangles than the first one, a geometric series.
  float fall(std::size_t level) const {
    const float finest = static_cast<float>(first_all_),
                coarsest = std::min(finest / (falls_by * falls_by * falls_by), max_far);
    return power(finest / coarsest, static_cast<float>(level) / (level_count - 1));
  }

  // Fills `line_` with the centre line and radii of a shoot, without the points within the tolerance of the line
  // between their neighbours.
  void line_of(const Run& run, float tolerance) {
    line_.clear();
    const Segment* const segments = &moment_.segments[run.first];
    const auto point = [&](std::uint32_t i) { return i == 0 ? segments[0].start : segments[i - 1].end; };
    const auto radius = [&](std::uint32_t i) {
      return i < run.count ? segments[i].radius : segments[run.count - 1].radius_end;
    };
    std::uint32_t last = 0;
    line_.emplace_back(point(0), radius(0));
    for (std::uint32_t end = 2; end <= run.count; ++end) {
      const glm::vec3 start = point(last), line = point(end) - start;
      const float length_squared = std::max(glm::dot(line, line), 1e-12f);
      bool straight = true;
      for (std::uint32_t i = last + 1; i < end && straight; ++i) {
        const glm::vec3 from_start = point(i) - start,
                        deviation = from_start - glm::dot(from_start, line) / length_squared * line;
        straight = glm::dot(deviation, deviation) <= tolerance * tolerance;
      }
      if (straight) continue;
      last = end - 1;
      line_.emplace_back(point(last), radius(last));
    }
    line_.emplace_back(point(run.count), radius(run.count));
  }

  // The number of sides of a shoot, by its radius over that of the thickest.
  std::uint32_t sides(std::size_t level, float radius) const {
    const float share = radius / moment_.segments[shoots_[0].first].radius;
    return sides_of[level][share > shares[0] ? 0 : share > shares[1] ? 1 : 2];
  }

  // Adds the shoots as tubes, the thickest first, until a budget of triangles is used up; 0: no limit.
  void add_wood(std::size_t level, float budget) {
    float spent = 0;
    const std::vector<bool> retained = leafy_ || level == 0 ? std::vector<bool>() : outermost();
    for (std::size_t pass = retained.empty() ? 1 : 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < shoots_.size(); ++i) {
        if (!retained.empty() && retained[i] != (pass == 0)) continue;
        line_of(shoots_[i], bend[level] * height_);
        const float radius = moment_.segments[shoots_[i].first].radius;
        const std::uint32_t n = sides(level, radius);
        const auto cost = static_cast<float>(n * (2 * (line_.size() - 1) - 1));
        if (budget > 0 && i > 0 && pass == 1 && spent + cost > budget) {
          made_.tolerance[level] = std::max(made_.tolerance[level], 2 * radius);
          break;
        }
        spent += cost;
        add_tube(n);
      }
  }

  // Which shoots reach farthest in a direction, with their ancestors: these are retained where leaves do not cover the
  // outline.
  std::vector<bool> outermost() const {
    std::vector<bool> retained(shoots_.size(), false);
    std::vector<std::uint32_t> of_segment(moment_.segments.size());
    for (std::uint32_t i = 0; i < shoots_.size(); ++i)
      std::fill_n(of_segment.begin() + shoots_[i].first, shoots_[i].count, i);
    constexpr int below = 3;  // side of the trunks' feet
    for (int side = 0; side < 6; ++side) {
      if (side == below) continue;
      float farthest = -std::numeric_limits<float>::max();
      std::int32_t segment = -1;
      for (std::size_t i = 0; i < moment_.segments.size(); ++i) {
        const float reach = (side % 2 ? -1.0f : 1.0f) * moment_.segments[i].end[side / 2];
        if (reach <= farthest) continue;
        farthest = reach;
        segment = static_cast<std::int32_t>(i);
      }
      while (segment >= 0) {
        const std::uint32_t shoot = of_segment[static_cast<std::size_t>(segment)];
        retained[shoot] = true;
        segment = moment_.segments[shoots_[shoot].first].parent;
      }
    }
    return retained;
  }

  // Makes room for more vertices and triangles, which are written next.
  void append_room(std::size_t vertices, std::size_t more) {
    mesh_->positions.resize(mesh_->positions.size() + 3 * vertices);
    mesh_->normals.resize(mesh_->normals.size() + 3 * vertices);
    mesh_->indices.resize(mesh_->indices.size() + 3 * more);
    place_ = mesh_->positions.data() + mesh_->positions.size() - 3 * vertices;
    normal_ = mesh_->normals.data() + mesh_->normals.size() - 3 * vertices;
    index_ = mesh_->indices.data() + mesh_->indices.size() - 3 * more;
    sky_.resize(sky_.size() + vertices);
    next_sky_ = sky_.data() + sky_.size() - vertices;
  }

  // Adds a tube along `line_` that ends in a point.
  void add_tube(std::uint32_t n) {
    append_room(n * (line_.size() - 1) + 1, n * (2 * line_.size() - 3));
    glm::vec3 right(0);
    for (std::size_t i = 0; i < line_.size(); ++i) {
      const bool last = i + 1 == line_.size();
      const glm::vec3 before = i > 0 ? line_[i].first - line_[i - 1].first : line_[1].first - line_[0].first,
                      after = last ? before : line_[i + 1].first - line_[i].first;
      const glm::vec3 sum = before + after;
      const float length = glm::length(sum);
      const glm::vec3 direction = length > 0 ? sum / length : glm::vec3(0, 1, 0);
      const std::uint8_t sky = visibility_.at(line_[i].first);
      const std::uint32_t first = next_vertex();
      if (last) {
        vertex(line_[i].first, direction, sky);
        for (std::uint32_t k = 0; k < n; ++k) triangle(first - n + k, first - n + (k + 1) % n, first);
        return;
      }
      const glm::vec3 perpendicular = right - glm::dot(right, direction) * direction;
      right =
          glm::dot(perpendicular, perpendicular) > 1e-4f ? glm::normalize(perpendicular) : any_perpendicular(direction);
      const glm::vec3 forward = glm::cross(direction, right);
      for (std::uint32_t k = 0; k < n; ++k) {
        const SinCos turn = turns_[n][k];
        const glm::vec3 out = turn.cosine * right + turn.sine * forward;
        vertex(line_[i].first + line_[i].second * out, out, sky);
        if (i == 0) continue;
        const std::uint32_t next = (k + 1) % n;
        triangle(first - n + k, first - n + next, first + next);
        triangle(first - n + k, first + next, first + k);
      }
    }
  }

  // Writes the next vertex.
  void vertex(const glm::vec3& place, const glm::vec3& normal, std::uint8_t sky) {
    put(place, place_);
    put(normal, normal_);
    place_ += 3;
    normal_ += 3;
    *next_sky_++ = sky;
  }

  // Index of the vertex that is written next.
  std::uint32_t next_vertex() const { return static_cast<std::uint32_t>(next_sky_ - sky_.data()); }

  // Writes the next triangle.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    *index_++ = a;
    *index_++ = b;
    *index_++ = c;
  }

  // The visible share of the sky at each sheet, 0 … 255.
  std::vector<std::uint8_t> sky_of(std::span<const Sheet> sheets) const {
    return visibility_.of(sheets.size(), [&](std::size_t i) -> const glm::vec3& { return sheets[i].middle; });
  }

  // Adds a leaf of two triangles, folded up along the midrib.
  void add_folded(const Sheet& leaf, std::uint8_t sky) {
    static const SinCos fold = sincos_degrees(folded);
    const glm::vec3 face = leaf.face(), tip = 0.5f * leaf.length * leaf.along;
    const glm::vec3 out = fold.cosine * leaf.across, up = fold.sine * face;
    const glm::vec3 normal_up = fold.cosine * face, normal_across = fold.sine * leaf.across;
    const float half_width = leaf.area / leaf.length;
    add_corners({leaf.middle - tip, leaf.middle + half_width * (up + out), leaf.middle + half_width * (up - out),
                 leaf.middle + tip},
                {face, normal_up - normal_across, normal_up + normal_across, face}, sky);
  }

  // Adds a sheet of two triangles in a plane.
  void add_flat(const Sheet& leaf, std::uint8_t sky) {
    std::array<glm::vec3, 4> places = leaf.corners();
    for (glm::vec3& place : places) place += leaf.middle;
    const glm::vec3 face = leaf.face();
    add_corners(places, {face, face, face, face}, sky);
  }

  // Adds two triangles between a base, two sides and a tip.
  void add_corners(const std::array<glm::vec3, 4>& places, const std::array<glm::vec3, 4>& normals, std::uint8_t sky) {
    const std::uint32_t first = next_vertex();
    for (std::size_t k = 0; k < places.size(); ++k) vertex(places[k], normals[k], sky);
    triangle(first, first + 1, first + 3);
    triangle(first, first + 3, first + 2);
  }

  // Adds fewer sheets: each group gets a share of the remaining triangles by its number of sheets.
  void add_merged(std::size_t level, const SheetGroup& group, float triangles_left) {
    const std::size_t own_count = group.sheets.all().size();
    if (own_count == 0) return;
    const float share = static_cast<float>(own_count) / static_cast<float>(sheet_count());
    const auto count = static_cast<std::size_t>(std::max(0.5f * triangles_left * share, 1.0f));
    Box target = group.reach;
    if (covers_outline(group.sheets))
      target = {{first_level_box_.low.x, group.reach.low.y, first_level_box_.low.z}, first_level_box_.high};
    const std::vector<Sheet> merged = group.sheets.merged(count, target);
    append_room(4 * merged.size(), 2 * merged.size());
    const std::vector<std::uint8_t> sky = sky_of(merged);
    for (std::size_t i = 0; i < merged.size(); ++i) {
      if (!merged[i].one) made_.tolerance[level] = std::max(made_.tolerance[level], merged[i].length);
      add_flat(merged[i], sky[i]);
    }
  }

  const Moment& moment_;
  std::array<SheetGroup, 2> groups_;
  SkyVisibility visibility_;
  TreeLevels made_;
  std::vector<Run> shoots_;
  Box tree_box_;         // of the segments' ends
  Box first_level_box_;  // of the first level's vertices
  bool leafy_ = false;
  float height_ = 0;
  std::size_t first_wood_ = 0, first_all_ = 0;
  std::vector<std::pair<glm::vec3, float>> line_;
  PlantMesh* out_ = nullptr;
  Mesh* mesh_ = nullptr;  // of *out_
  // Where the next vertex and triangle are written.
  float *place_ = nullptr, *normal_ = nullptr;
  std::uint32_t* index_ = nullptr;
  std::uint8_t* next_sky_ = nullptr;
  std::array<std::array<SinCos, max_sides>, max_sides + 1> turns_{};  // by number of sides
  std::vector<std::uint8_t> sky_;
};

}  // namespace

// Builds `count` levels of detail of a tree; the areas are those of a leaf and of a blossom of scale 1.
TreeLevels levels_of(const Moment& moment, std::span<const Organ> organs, float leaf_area, float blossom_area,
                     std::size_t count) {
  return LevelBuilder(moment, organs, leaf_area, blossom_area).run(count);
}

}  // namespace panicle::growth
