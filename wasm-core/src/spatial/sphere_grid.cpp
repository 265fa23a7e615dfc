#include "spatial/sphere_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace panicle {
namespace {

constexpr double clearance = 1.00001;
constexpr double max_depth = 1e6;                // in diameters of the probe
constexpr double edge_per_radius = 3.0;          // small cells make add slow, large ones probe: flat from 2 to 4
constexpr double margin = 1.0001;                // covers the rounding of the overlap test, clearance included
constexpr std::int32_t farthest_cell = 1 << 30;  // cells beyond share the outermost ones
constexpr std::uint32_t first_capacity = 8;

// Whether a sphere's numbers are finite and its radius is not negative.
bool is_valid(const Sphere& sphere) {
  // A sum of finite floats is finite in double; any infinity or NaN survives it.
  const double sum = double{sphere.centre.x} + sphere.centre.y + sphere.centre.z + sphere.radius;
  return std::isfinite(sum) && sphere.radius >= 0;
}

// Sum of the pushes of all spheres in contact on one probe. In double, where no square of a float overflows or
// vanishes. `tie` is the direction if the centres coincide.
class PushSum {
 public:
  PushSum(const Sphere& probe, const glm::vec3& tie) : centre_(probe.centre), radius_(probe.radius), tie_(tie) {}

  // Adds the push of another sphere if it touches the probe.
  void add_contact(const Sphere& other) {
    const double x = centre_.x - other.centre.x;
    const double y = centre_.y - other.centre.y;
    const double z = centre_.z - other.centre.z;
    const double square = x * x + y * y + z * z;
    const double reach = (radius_ + other.radius) * clearance;
    if (square < reach * reach) [[unlikely]] {
      const double distance = std::sqrt(square);
      const double share = std::min((reach - distance) / (2 * radius_), max_depth);
      force_ += distance > 0 ? glm::dvec3(x, y, z) * (share / distance) : tie_ * share;
      ++contacts_;
    }
  }

  // The mean push over all contacts.
  Push push() const { return contacts_ == 0 ? Push{} : Push{contacts_, glm::vec3(force_ / double(contacts_))}; }

 private:
  glm::dvec3 centre_;
  double radius_;
  glm::dvec3 tie_;
  glm::dvec3 force_{0};
  std::uint32_t contacts_ = 0;
};

// A hash of a cell's coordinates.
std::uint32_t hash_of(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u;
  h = (h ^ (h >> 15) ^ static_cast<std::uint32_t>(y)) * 0x85ebca6bu;
  h = (h ^ (h >> 13) ^ static_cast<std::uint32_t>(z)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

}  // namespace

// An empty grid for spheres of radii up to `largest`; it adapts to larger ones.
SphereGrid::SphereGrid(float largest) {
  size_cells(std::isfinite(largest) && largest > 0 ? largest : 1);
  table_.resize(64);
}

// Sets the cells' width from the largest radius.
void SphereGrid::size_cells(float largest) {
  largest_ = largest;
  edge_ = edge_per_radius * largest;
  per_edge_ = 1 / edge_;
}

// The cell of a coordinate: monotone, so that a range of coordinates covers the cells of all points within. Any cell
// for NaN.
std::int32_t SphereGrid::cell_of(double coordinate) const {
  const double place = coordinate * per_edge_;
  if (!(place > -farthest_cell)) return -farthest_cell;
  if (!(place < farthest_cell)) return farthest_cell;
  const std::int32_t whole = static_cast<std::int32_t>(place);
  return whole - (place < whole ? 1 : 0);
}

// Where a cell begins along an axis; the outermost have no end.
double SphereGrid::lower_end(std::int32_t cell) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return cell <= -farthest_cell ? -infinity : cell > farthest_cell ? infinity : cell * edge_;
}

// The slot of a cell, or the free one where it belongs.
std::size_t SphereGrid::slot_of(const Key& key) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash_of(key.x, key.y, key.z) & mask;
  while (table_[slot].capacity != 0 && table_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

// Doubles the hash table of cells.
void SphereGrid::grow_table() {
  std::vector<Cell> old(table_.size() * 2);
  old.swap(table_);
  for (const Cell& cell : old) {
    if (cell.capacity != 0) table_[slot_of(cell.key)] = cell;
  }
}

// Adds an id to the list of a cell, and the cell to the hash table where it is new.
void SphereGrid::append(const Key& key, std::uint32_t id) {
  Cell* cell = &table_[slot_of(key)];
  if (cell->count == cell->capacity) {
    if (cell->capacity == 0) {
      if (++occupied_ * 2 > table_.size()) {
        grow_table();
        cell = &table_[slot_of(key)];
      }
      cell->key = key;
    }
    // A full list moves to the end with twice the room.
    const std::uint32_t capacity = std::max(first_capacity, cell->capacity * 2);
    const std::uint32_t first = static_cast<std::uint32_t>(lists_.size());
    lists_.resize(lists_.size() + capacity);
    std::copy_n(lists_.begin() + cell->first, cell->count, lists_.begin() + first);
    cell->first = first;
    cell->capacity = capacity;
  }
  lists_[cell->first + cell->count++] = id;
}

// Adds a sphere to every cell from where a probe of up to largest_ could touch it.
void SphereGrid::enlist(std::uint32_t id) {
  const glm::dvec3 centre(spheres_[id].centre);
  const double reach = (double{spheres_[id].radius} + largest_) * margin;
  const Key from{cell_of(centre.x - reach), cell_of(centre.y - reach), cell_of(centre.z - reach)};
  const Key to{cell_of(centre.x + reach), cell_of(centre.y + reach), cell_of(centre.z + reach)};
  // Squared distance from the centre to a cell along one axis.
  const auto gap = [this](double coordinate, std::int32_t cell) {
    const double away = std::max({lower_end(cell) - coordinate, coordinate - lower_end(cell + 1), 0.0});
    return away * away;
  };
  for (std::int32_t x = from.x; x <= to.x; ++x) {
    const double gap_x = gap(centre.x, x);
    for (std::int32_t y = from.y; y <= to.y; ++y) {
      const double gap_xy = gap_x + gap(centre.y, y);
      for (std::int32_t z = from.z; z <= to.z; ++z) {
        if (gap_xy + gap(centre.z, z) < reach * reach) append({x, y, z}, id);
      }
    }
  }
}

// Adds a sphere and returns its id; `no_sphere` if it is not valid. A sphere larger than all before makes the cells
// larger.
std::uint32_t SphereGrid::add(const Sphere& sphere) {
  if (!is_valid(sphere)) return no_sphere;
  nearby_.forget();
  const std::uint32_t id = static_cast<std::uint32_t>(spheres_.size());
  spheres_.push_back(sphere);
  if (sphere.radius <= largest_) {
    enlist(id);
  } else {
    // Doubling keeps the number of new layouts small however the sizes come.
    size_cells(std::max(sphere.radius, std::min(2 * largest_, std::numeric_limits<float>::max())));
    lists_.clear();
    table_.assign(table_.size(), Cell{});
    occupied_ = 0;
    for (std::uint32_t each = 0; each <= id; ++each) enlist(each);
  }
  return id;
}

// Copies the list of the cell around `centre` into groups. The padding of the last group has no radius and is never
// read.
void SphereGrid::gather(const glm::vec3& centre) const {
  const Key key{cell_of(centre.x), cell_of(centre.y), cell_of(centre.z)};
  const Cell& cell = table_[slot_of(key)];
  nearby_.low = {lower_end(key.x), lower_end(key.y), lower_end(key.z)};
  nearby_.high = {lower_end(key.x + 1), lower_end(key.y + 1), lower_end(key.z + 1)};
  nearby_.ids.assign(lists_.begin() + cell.first, lists_.begin() + cell.first + cell.count);
  nearby_.groups.assign((cell.count + lanes - 1) / lanes, Group{});
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    const Sphere& sphere = spheres_[nearby_.ids[i]];
    Group& group = nearby_.groups[i / lanes];
    group.x[i % lanes] = sphere.centre.x;
    group.y[i % lanes] = sphere.centre.y;
    group.z[i % lanes] = sphere.centre.z;
    group.radius[i % lanes] = sphere.radius;
  }
}

// The mean push on a probe by all spheres that touch it, but the sphere `except`. `tie` is the direction of a push
// where centres coincide.
Push SphereGrid::probe(const Sphere& probe, std::uint32_t except, const glm::vec3& tie) const {
  PushSum sum(probe, tie);
  if (!(probe.radius <= largest_)) {
    if (!is_valid(probe)) return {};
    for (std::uint32_t id = 0; id < spheres_.size(); ++id) {
      if (id != except) sum.add_contact(spheres_[id]);
    }
    return sum.push();
  }
  if (!nearby_.around(probe.centre)) gather(probe.centre);
  const std::uint32_t* ids = nearby_.ids.data();
  const std::uint32_t count = static_cast<std::uint32_t>(nearby_.ids.size());
  for (std::uint32_t first = 0; first < count; first += lanes) {
    // A rough test in float, four at a time; candidates are tested exactly. Overflows pass.
    const Group& group = nearby_.groups[first / lanes];
    const Four x = group.x - probe.centre.x;
    const Four y = group.y - probe.centre.y;
    const Four z = group.z - probe.centre.z;
    const Four reach = (group.radius + probe.radius) * static_cast<float>(margin);
    const auto far = x * x + y * y + z * z > reach * reach;
    if (all(far)) continue;
    const std::uint32_t end = std::min(count - first, lanes);
    for (std::uint32_t lane = 0; lane < end; ++lane) {
      if (!far[lane] && ids[first + lane] != except) sum.add_contact(spheres_[ids[first + lane]]);
    }
  }
  return sum.push();
}

}  // namespace panicle
