#include "models/bunch/measures/images/measures_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "foundation/order.hpp"
#include "models/bunch/measures/images/silhouette.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

constexpr float pixels_to_radius = 6;
constexpr float max_pixels = 1200;
constexpr float least_seen = 0.05f;  // of a berry's outline
constexpr std::size_t points = 5;    // on a pedicel

// A berry, or a point of a pedicel, in the order in which they are seen.
struct Entry {
  float depth = 0;
  glm::vec2 place{0};
  std::uint32_t index = 0;
  bool berry = true;

  // Nearest first; at equal depth by place, so that the order of berries never matters.
  bool operator<(const Entry& other) const {
    return std::tie(other.depth, place.y, place.x, berry) < std::tie(depth, other.place.y, other.place.x, other.berry);
  }
};

// The length of a stem.
float length_of(const Segment& stem) {
  const glm::vec3 along = stem.end - stem.start;
  return std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
}

// The scalar product.
float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Paints berries front to back and counts pixels: a clear pixel that is painted is visible. For balls that do not
// overlap the order of their centres is the order in which any line of sight meets them, since a plane between them is
// at right angles to the line of centres; for other forms nearly so. Reuses its buffers from view to view.
class VisibilityRenderer {
 public:
  // Sums the length of all pedicels.
  explicit VisibilityRenderer(const Subject& subject) : subject_(subject) {
    for (const Segment& pedicel : subject.pedicels) pedicel_length_ += length_of(pedicel);
  }

  // Renders the view from the direction `towards`.
  void look(glm::vec3 towards, bool at_pedicels) {
    const View view = view_from(towards);
    prepare(view, at_pedicels);
    std::uint32_t seen = 0;
    float length = 0;
    for (const Entry& entry : entries_) {
      if (!entry.berry) {
        if (!image_.at(grid_.column_at(entry.place.x), grid_.row_at(entry.place.y)))
          length += length_of(subject_.pedicels[entry.index]) / points;
        continue;
      }
      const DrawnPixels inked = draw(image_, grid_, projected_[entry.index]);
      seen += inked.pixels > 0 && static_cast<float>(inked.fresh) >= least_seen * static_cast<float>(inked.pixels);
    }
    berries_ = static_cast<float>(seen) / static_cast<float>(projected_.size());
    pedicels_ = pedicel_length_ > 0 ? length / pedicel_length_ : 0;
  }

  // The share of the berries, and of the pedicels' length, visible in the last view; 0 … 1.
  float berries() const { return berries_; }
  float pedicels() const { return pedicels_; }

 private:
  // Projects all berries and, `with_pedicels`, points along the pedicels; sorts them by depth; clears an image that
  // holds them all.
  void prepare(const View& view, bool with_pedicels) {
    projected_.clear();
    entries_.clear();
    glm::vec2 low(1e30f), high(-1e30f);
    for (const BerryBody& berry : subject_.berries) {
      const ProjectedBerry& one = projected_.emplace_back(project(berry, view));
      low = {std::min(low.x, one.centre.x - one.half.x), std::min(low.y, one.centre.y - one.half.y)};
      high = {std::max(high.x, one.centre.x + one.half.x), std::max(high.y, one.centre.y + one.half.y)};
      entries_.push_back({one.depth, one.centre, static_cast<std::uint32_t>(projected_.size() - 1), true});
    }
    for (std::uint32_t i = 0; with_pedicels && i < subject_.pedicels.size(); ++i) {
      const Segment& stem = subject_.pedicels[i];
      for (std::size_t k = 0; k < points; ++k) {
        const glm::vec3 p = stem.start + (static_cast<float>(k) + 0.5f) / points * (stem.end - stem.start);
        entries_.push_back({dot(p, view.towards), {dot(p, view.right), dot(p, view.up)}, i, false});
      }
    }
    sort_entries();
    const float size = std::max(high.x - low.x, high.y - low.y);
    grid_ = PixelGrid::over(low, high, std::max(subject_.mean_radius / pixels_to_radius, size / max_pixels), 1);
    image_.reset(grid_.columns, grid_.rows);
  }

  const Subject& subject_;
  // Sorts by depth, and at equal depth by the other members, which hardly ever moves anything.
  void sort_entries() {
    depths_.clear();
    for (const Entry& entry : entries_) depths_.push_back(-entry.depth);
    sorted_.clear();
    for (const std::uint32_t place : order_of(depths_)) {
      sorted_.push_back(entries_[place]);
      for (std::size_t i = sorted_.size() - 1; i > 0 && sorted_[i] < sorted_[i - 1]; --i)
        std::swap(sorted_[i], sorted_[i - 1]);
    }
    std::swap(entries_, sorted_);
  }

  float pedicel_length_ = 0, berries_ = 0, pedicels_ = 0;
  std::vector<ProjectedBerry> projected_;
  std::vector<Entry> entries_, sorted_;
  std::vector<float> depths_;
  PixelGrid grid_;
  BitImage image_;
};

}  // namespace

// How many berries are visible: the mean over 26 directions, from the front and from the side; and the mean share of
// pedicels from four sides.
Visibility visibility(const Subject& subject) {
  Visibility result;
  VisibilityRenderer onlooker(subject);
  constexpr float directions = 26, faces = 4;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const bool face = y == 0 && (x == 0) != (z == 0);
        onlooker.look(glm::vec3(x, y, z), face);
        result.mean += onlooker.berries() / directions;
        if (face) result.pedicels += onlooker.pedicels() / faces;
        if (face && z == 1) result.front = onlooker.berries();
        if (face && x == -1) result.side = onlooker.berries();
      }
  return result;
}

}  // namespace panicle::bunch
