#include "models/growth/levels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "environment/openness.hpp"
#include "foundation/mathematics.hpp"
#include "geometry/turn.hpp"
#include "models/growth/foliage.hpp"

namespace panicle::growth {
namespace {

constexpr std::array<const char*, level_count> names{"level0", "level1", "level2", "level3"};
// Triangles fall by so much a level at the least, and the last has no more than so many.
constexpr float falls_by = 2.75f, most_far = 144;
// Of all triangles wood's share in the first level, so much is left to it in each: far away leaves tell more.
constexpr std::array<float, level_count> wood_share{1, 0.9f, 0.75f, 0.6f};
// How far what is drawn may leave a shoot's own line, of the tree's height.
constexpr std::array<float, level_count> bend{0.0008f, 0.004f, 0.012f, 0.04f};
// Sides of a shoot by its thickness against the thickest: of those thicker than each share.
constexpr std::array<float, 2> shares{0.5f, 0.18f};
constexpr std::array<std::array<std::uint32_t, 3>, level_count> sides_of{
    {{{8, 5, 3}}, {{5, 4, 3}}, {{4, 3, 3}}, {{3, 3, 3}}}};
constexpr std::uint32_t most_sides = 8;
constexpr float folded = 20;           // degrees that each half of a leaf stands up
constexpr float least_breadth = 0.5f;  // of a merged leaf, of its length: needles together are a tuft
constexpr float sparse = 0.8f;         // leaves that reach less far than this share of the tree do not tell its outline
constexpr float sky_cells = 10;
constexpr std::uint32_t sky_directions = 10;
constexpr std::size_t few = 8;

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};

  void hold(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void hold(const Mesh& mesh, std::size_t from) {
    for (std::size_t v = 3 * from; v + 2 < mesh.positions.size(); v += 3)
      hold({mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]});
  }
};

// The segments of one shoot, which stand side by side.
struct Run {
  std::uint32_t first = 0, count = 0;
};

// A leaf, or several as one: a rhombus about its middle.
struct Sheet {
  glm::vec3 middle{0}, along{0}, across{0};  // along to its tip and across, of length 1
  float area = 0, length = 0;
};

glm::vec3 turned(const glm::vec4& q, const glm::vec3& v) {
  const glm::vec3 u(q.x, q.y, q.z), w = 2.0f * glm::cross(u, v);
  return v + q.w * w + glm::cross(u, w);
}

// A place's cell in a box of 2¹⁰ cells a side, the bits of its three numbers by turns: near ones mostly have near
// codes.
std::uint32_t code_of(const glm::vec3& p, const Box& box) {
  const glm::vec3 size = glm::max(box.high - box.low, glm::vec3(1e-6f));
  const float edge = std::max({size.x, size.y, size.z});
  std::uint32_t code = 0;
  for (int k = 0; k < 3; ++k) {
    auto cell = static_cast<std::uint32_t>(std::clamp((p[k] - box.low[k]) / edge * 1023, 0.0f, 1023.0f));
    cell = (cell | cell << 16) & 0x030000ffu;
    cell = (cell | cell << 8) & 0x0300f00fu;
    cell = (cell | cell << 4) & 0x030c30c3u;
    cell = (cell | cell << 2) & 0x09249249u;
    code |= cell << k;
  }
  return code;
}

class Maker {
 public:
  Maker(const Moment& moment, std::span<const Organ> leaves, float blade_area)
      : moment_(moment), blade_area_(blade_area), open_(openness_of(moment, leaves, blade_area)) {
    find_shoots();
    find_leaves(leaves);
  }

  Levels run() {
    for (std::size_t k = 0; k < level_count; ++k) make(k);
    return std::move(made_);
  }

 private:
  static Openness openness_of(const Moment& moment, std::span<const Organ> leaves, float blade_area) {
    std::vector<Screen> screens;
    screens.reserve(leaves.size());
    for (const Organ& leaf : leaves) screens.push_back({leaf.position, 0.5f * blade_area * leaf.scale * leaf.scale});
    return {moment.segments, screens, sky_cells, sky_directions};
  }

  // Thickest first: whatever bears a shoot stands before it.
  void find_shoots() {
    const auto count = static_cast<std::uint32_t>(moment_.segments.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i == 0 || moment_.axes[i] != moment_.axes[i - 1]) shoots_.push_back({i, 0});
      ++shoots_.back().count;
      tree_.hold(moment_.segments[i].start);
      tree_.hold(moment_.segments[i].end);
    }
    std::sort(shoots_.begin(), shoots_.end(), [&](const Run& a, const Run& b) {
      const float one = moment_.segments[a.first].radius, other = moment_.segments[b.first].radius;
      return one != other ? one > other : a.first < b.first;
    });
    high_ = shoots_.empty() ? 0 : std::max(tree_.high.y - tree_.low.y, 1e-3f);
  }

  void find_leaves(std::span<const Organ> leaves) {
    Box box;
    std::vector<Sheet> found;
    for (const Organ& leaf : leaves) {
      if (leaf.tag == fallen_tag || !(blade_area_ > 0)) continue;
      Sheet sheet;
      sheet.along = turned(leaf.rotation, {0, 1, 0});
      sheet.across = turned(leaf.rotation, {1, 0, 0});
      sheet.length = leaf.scale;
      sheet.area = blade_area_ * leaf.scale * leaf.scale;
      sheet.middle = leaf.position + 0.5f * leaf.scale * sheet.along;
      box.hold(sheet.middle);
      found.push_back(sheet);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < found.size(); ++i) order.emplace_back(code_of(found[i].middle, box), i);
    std::sort(order.begin(), order.end());
    leaves_.reserve(found.size());
    for (const auto& [code, i] : order) leaves_.push_back(found[i]);
    const glm::vec3 crown = box.high - box.low, all = tree_.high - tree_.low;
    leafy_ = leaves_.size() >= few && crown.x > sparse * all.x && crown.z > sparse * all.z &&
             box.high.y > sparse * tree_.high.y;
  }

  void make(std::size_t level) {
    PlantMesh& out = made_.meshes[level];
    out.name = names[level];
    out.material = "level";
    mesh_ = &out.mesh;
    sky_.clear();
    const float share = leafy_ ? wood_share[level] : 1;
    const float wood = level == 0 ? 0 : share * static_cast<float>(first_wood_) / fall(level);
    add_wood(level, wood);
    const auto woody = static_cast<std::uint32_t>(mesh_->positions.size() / 3),
               woody_indices = static_cast<std::uint32_t>(mesh_->indices.size());
    if (level == 0) {
      first_wood_ = woody_indices / 3;
      for (const Sheet& leaf : leaves_) add_folded(leaf);
      first_all_ = mesh_->indices.size() / 3;
      whole_.hold(*mesh_, 0);
      hanging_.hold(*mesh_, woody);
    } else if (!leaves_.empty()) {
      const float all = static_cast<float>(first_all_) / fall(level);
      add_merged(level, (all - static_cast<float>(woody_indices / 3)) / 2);
    }
    const auto vertices = static_cast<std::uint32_t>(mesh_->positions.size() / 3),
               indices = static_cast<std::uint32_t>(mesh_->indices.size());
    out.runs = {{"bark", 0, woody, 0, woody_indices},
                {"leaves", woody, vertices - woody, woody_indices, indices - woody_indices}};
    out.columns.add("sky", std::move(sky_));
    sky_ = {};
  }

  // By how much a level has fewer triangles than the first.
  float fall(std::size_t level) const {
    const float all = static_cast<float>(first_all_), last = std::min(all / (falls_by * falls_by * falls_by), most_far);
    return power(all / last, static_cast<float>(level) / (level_count - 1));
  }

  // The ends of a shoot's pieces, but those that lie as good as on the line between others.
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
      const glm::vec3 from = point(last), way = point(end) - from;
      const float square = std::max(glm::dot(way, way), 1e-12f);
      bool straight = true;
      for (std::uint32_t i = last + 1; i < end && straight; ++i) {
        const glm::vec3 to = point(i) - from, off = to - glm::dot(to, way) / square * way;
        straight = glm::dot(off, off) <= tolerance * tolerance;
      }
      if (straight) continue;
      last = end - 1;
      line_.emplace_back(point(last), radius(last));
    }
    line_.emplace_back(point(run.count), radius(run.count));
  }

  std::uint32_t sides(std::size_t level, float radius) const {
    const float share = radius / moment_.segments[shoots_[0].first].radius;
    return sides_of[level][share > shares[0] ? 0 : share > shares[1] ? 1 : 2];
  }

  // `budget`: triangles; 0: as many as there are.
  void add_wood(std::size_t level, float budget) {
    float spent = 0;
    const std::vector<bool> kept = leafy_ || level == 0 ? std::vector<bool>() : outermost();
    for (std::size_t pass = kept.empty() ? 1 : 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < shoots_.size(); ++i) {
        if (!kept.empty() && kept[i] != (pass == 0)) continue;
        line_of(shoots_[i], bend[level] * high_);
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

  // Where leaves do not tell a tree's outline: the shoots that do, with what bears them.
  std::vector<bool> outermost() const {
    std::vector<bool> kept(shoots_.size(), false);
    std::vector<std::uint32_t> of_segment(moment_.segments.size());
    for (std::uint32_t i = 0; i < shoots_.size(); ++i)
      std::fill_n(of_segment.begin() + shoots_[i].first, shoots_[i].count, i);
    for (int side = 0; side < 6; ++side) {
      float farthest = -std::numeric_limits<float>::max();
      std::int32_t at = -1;
      for (std::size_t i = 0; i < moment_.segments.size(); ++i) {
        const float far = (side % 2 ? -1.0f : 1.0f) * moment_.segments[i].end[side / 2];
        if (far <= farthest) continue;
        farthest = far;
        at = static_cast<std::int32_t>(i);
      }
      while (at >= 0) {
        const std::uint32_t shoot = of_segment[static_cast<std::size_t>(at)];
        kept[shoot] = true;
        at = moment_.segments[shoots_[shoot].first].parent;
      }
    }
    return kept;
  }

  // Along `line_`, to a point.
  void add_tube(std::uint32_t n) {
    glm::vec3 right(0);
    for (std::size_t i = 0; i < line_.size(); ++i) {
      const bool last = i + 1 == line_.size();
      const glm::vec3 before = i > 0 ? line_[i].first - line_[i - 1].first : line_[1].first - line_[0].first,
                      behind = last ? before : line_[i + 1].first - line_[i].first;
      const glm::vec3 both = before + behind;
      const float length = glm::length(both);
      const glm::vec3 way = length > 0 ? both / length : glm::vec3(0, 1, 0);
      const std::uint8_t sky = open_.at(line_[i].first);
      const auto first = static_cast<std::uint32_t>(sky_.size());
      if (last) {
        vertex(line_[i].first, way, sky);
        for (std::uint32_t k = 0; k < n; ++k) put(mesh_->indices, first - n + k, first - n + (k + 1) % n, first);
        return;
      }
      const glm::vec3 flat = right - glm::dot(right, way) * way;
      right = glm::dot(flat, flat) > 1e-4f ? glm::normalize(flat) : beside(way);
      const glm::vec3 forward = glm::cross(way, right);
      for (std::uint32_t k = 0; k < n; ++k) {
        const SinCos turn = sincos_degrees(360 * static_cast<float>(k) / static_cast<float>(n));
        const glm::vec3 out = turn.cosine * right + turn.sine * forward;
        vertex(line_[i].first + line_[i].second * out, out, sky);
        if (i == 0) continue;
        const std::uint32_t next = (k + 1) % n;
        put(mesh_->indices, first - n + k, first - n + next, first + next);
        put(mesh_->indices, first - n + k, first + next, first + k);
      }
    }
  }

  void vertex(const glm::vec3& place, const glm::vec3& normal, std::uint8_t sky) {
    put(mesh_->positions, place);
    put(mesh_->normals, normal);
    sky_.push_back(sky);
  }

  // Two triangles, folded up along the midrib.
  void add_folded(const Sheet& leaf) {
    static const SinCos fold = sincos_degrees(folded);
    const float breadth = 2 * leaf.area / leaf.length;
    const glm::vec3 face = glm::cross(leaf.across, leaf.along), tip = 0.5f * leaf.length * leaf.along;
    const std::uint8_t sky = open_.at(leaf.middle);
    const auto first = static_cast<std::uint32_t>(sky_.size());
    vertex(leaf.middle - tip, face, sky);
    for (const float side : {1.0f, -1.0f}) {
      const glm::vec3 out = side * fold.cosine * leaf.across + fold.sine * face;
      vertex(leaf.middle + 0.5f * breadth * out, fold.cosine * face - side * fold.sine * leaf.across, sky);
    }
    vertex(leaf.middle + tip, face, sky);
    put(mesh_->indices, first, first + 1, first + 3);
    put(mesh_->indices, first, first + 3, first + 2);
  }

  void add_flat(const Sheet& leaf) {
    const glm::vec3 face = glm::cross(leaf.across, leaf.along), tip = 0.5f * leaf.length * leaf.along,
                    side = leaf.area / leaf.length * leaf.across;
    const std::uint8_t sky = open_.at(leaf.middle);
    const auto first = static_cast<std::uint32_t>(sky_.size());
    for (const glm::vec3& corner : {-tip, side, -side, tip}) vertex(leaf.middle + corner, face, sky);
    put(mesh_->indices, first, first + 1, first + 3);
    put(mesh_->indices, first, first + 3, first + 2);
  }

  // So many leaves, each in the place of as many that stand side by side: their middle, the area of them all, and the
  // way of one of them. Middles lie within the crown's outline: they are moved apart until it is what it was.
  void add_merged(std::size_t level, float wanted) {
    const std::size_t all = leaves_.size(),
                      count = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(wanted, 1.0f)), 1, all);
    std::vector<Sheet> merged;
    merged.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = i * all / count, to = (i + 1) * all / count;
      Sheet sheet = leaves_[from];
      if (to - from > 1) {
        sheet.area = 0;
        glm::vec3 sum(0);
        for (std::size_t k = from; k < to; ++k) {
          sheet.area += leaves_[k].area;
          sum += leaves_[k].area * leaves_[k].middle;
        }
        sheet.middle = sheet.area > 0 ? sum / sheet.area : leaves_[from].middle;
        const float breadth = std::max(2 * blade_area_, least_breadth);
        sheet.length = square_of(2 * sheet.area / breadth);
        made_.tolerance[level] = std::max(made_.tolerance[level], sheet.length);
      }
      merged.push_back(sheet);
    }
    spread(merged);
    for (const Sheet& sheet : merged) add_flat(sheet);
  }

  static float square_of(float area) { return std::sqrt(std::max(area, 1e-12f)); }

  void spread(std::vector<Sheet>& merged) const {
    Box target = hanging_;
    if (leafy_) target = {{whole_.low.x, hanging_.low.y, whole_.low.z}, whole_.high};
    Box middles, corners;
    for (const Sheet& sheet : merged) {
      middles.hold(sheet.middle);
      const glm::vec3 tip = 0.5f * sheet.length * sheet.along, side = sheet.area / sheet.length * sheet.across;
      for (const glm::vec3& corner : {-tip, side, -side, tip}) corners.hold(sheet.middle + corner);
    }
    for (int k = 0; k < 3; ++k) {
      const float reach = middles.high[k] - middles.low[k], over = corners.high[k] - corners.low[k] - reach,
                  wide = target.high[k] - target.low[k];
      const float factor = reach > 1e-4f ? std::max(wide - over, 0.0f) / reach : 1;
      const float low = target.low[k] + (middles.low[k] - corners.low[k]);
      for (Sheet& sheet : merged)
        sheet.middle[k] = reach > 1e-4f ? low + factor * (sheet.middle[k] - middles.low[k]) : sheet.middle[k];
    }
  }

  const Moment& moment_;
  float blade_area_;
  Openness open_;
  Levels made_;
  std::vector<Run> shoots_;
  std::vector<Sheet> leaves_;  // near ones side by side
  Box tree_, whole_, hanging_;
  bool leafy_ = false;
  float high_ = 0;
  std::size_t first_wood_ = 0, first_all_ = 0;
  std::vector<std::pair<glm::vec3, float>> line_;
  Mesh* mesh_ = nullptr;
  std::vector<std::uint8_t> sky_;
};

}  // namespace

Levels levels_of(const Moment& moment, std::span<const Organ> leaves, float blade_area) {
  return Maker(moment, leaves, blade_area).run();
}

}  // namespace panicle::growth
