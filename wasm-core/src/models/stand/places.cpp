#include "models/stand/places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/stand/messages.generated.hpp"

namespace panicle::stand {
namespace {

// A rectangle of the ground in metres: its corner with the least x and z, and its size. The y of these 2D vectors is
// the world's z.
struct Strip {
  glm::vec2 low, size;

  // The point at the shares u of the width and v of the depth.
  glm::vec2 at(float u, float v) const { return low + size * glm::vec2(u, v); }
  // Whether a place is inside.
  bool contains(const glm::vec2& p) const {
    const glm::vec2 in = p - low;
    return in.x >= 0 && in.y >= 0 && in.x <= size.x && in.y <= size.y;
  }
};

// The part of the ground that a layer is planted on: the whole width, and its share of the depth.
Strip strip_of(const Layer& layer, const Ground& ground) {
  const float from = layer.depth.from, to = layer.depth.to;
  return {{-0.5f * ground.width, (from - 0.5f) * ground.depth}, {ground.width, (to - from) * ground.depth}};
}

// Rounds towards 0 and clamps to 0 … `most`.
std::uint32_t whole(float value, float most) { return static_cast<std::uint32_t>(std::clamp(value, 0.0f, most)); }

// Random values of one layer for one purpose.
class RandomDraws {
 public:
  RandomDraws(std::uint64_t seed, std::string_view purpose, std::uint64_t layer)
      : seed_(seed), stream_(hash_combine(hash_text(purpose), layer)) {}
  // A random number, 0 … 1, for an address.
  float unit(std::uint64_t address) const { return random_unit(seed_, stream_, address); }
  // 64 random bits for an address.
  std::uint64_t bits(std::uint64_t address) const { return random_bits(seed_, stream_, address); }

 private:
  std::uint64_t seed_, stream_;
};

// Draws `count` independent, uniformly distributed spots in the strip.
std::vector<glm::vec2> random_spots(const Strip& strip, std::uint32_t count, const RandomDraws& draws) {
  std::vector<glm::vec2> spots;
  for (std::uint32_t i = 0; i < count; ++i) spots.push_back(strip.at(draws.unit(2 * i), draws.unit(2 * i + 1)));
  return spots;
}

// Stratified placement: cells as square as possible, with one plant at a random place in each; a draw decides which
// cells stay empty.
std::vector<glm::vec2> stratified_spots(const Strip& strip, std::uint32_t count, const RandomDraws& draws) {
  const float columns_if_square = std::sqrt(static_cast<float>(count) * strip.size.x / strip.size.y);
  const std::uint32_t columns = std::max(whole(columns_if_square + 0.5f, static_cast<float>(count)), 1u);
  const std::uint32_t rows = (count + columns - 1) / columns;
  std::vector<std::uint32_t> cells(static_cast<std::size_t>(columns) * rows);
  for (std::uint32_t i = 0; i < cells.size(); ++i) cells[i] = i;
  std::sort(cells.begin(), cells.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t of_a = draws.bits(3 * a + 2), of_b = draws.bits(3 * b + 2);
    return of_a != of_b ? of_a < of_b : a < b;
  });
  cells.resize(count);
  std::sort(cells.begin(), cells.end());
  std::vector<glm::vec2> spots;
  for (const std::uint32_t cell : cells) {
    const std::uint32_t column = cell % columns, row = cell / columns;
    const float u = (static_cast<float>(column) + draws.unit(3 * cell)) / static_cast<float>(columns);
    const float v = (static_cast<float>(row) + draws.unit(3 * cell + 1)) / static_cast<float>(rows);
    spots.push_back(strip.at(u, v));
  }
  return spots;
}

// Blue noise by dart throwing (Cook 1986): a dart nearer than `apart` to an earlier one is thrown again, up to this
// many throws for each plant. Jammed, darts cover 0.547 of a plane with discs of that diameter.
constexpr std::uint32_t throws = 60;
constexpr float max_cells = 1e6f;  // along an edge: the last of them is wider in a strip that needs more

// Throws darts at the strip, and keeps those at least `apart` from all before, until there are `count` of them. The
// spots in each cell of a grid form a linked list; cells are at least `apart` wide, so only nine are searched.
std::vector<glm::vec2> blue_noise_spots(const Strip& strip, std::uint32_t count, float apart,
                                        const RandomDraws& draws) {
  const float mean_distance = std::sqrt(strip.size.x * strip.size.y / static_cast<float>(count));
  const float cell_size = std::max(apart, 0.7f * mean_distance);
  const std::uint32_t columns = whole(strip.size.x / cell_size, max_cells) + 1;
  const std::uint32_t rows = whole(strip.size.y / cell_size, max_cells) + 1;
  std::vector<std::int32_t> first_in_cell(static_cast<std::size_t>(columns) * rows, -1), next_in_cell;
  std::vector<glm::vec2> spots;
  for (std::uint32_t i = 0; i < throws * count && spots.size() < count; ++i) {
    const glm::vec2 dart = strip.at(draws.unit(2 * i), draws.unit(2 * i + 1));
    const std::uint32_t x = whole((dart.x - strip.low.x) / cell_size, static_cast<float>(columns - 1));
    const std::uint32_t z = whole((dart.y - strip.low.y) / cell_size, static_cast<float>(rows - 1));
    bool is_free = true;
    for (std::uint32_t row = z > 0 ? z - 1 : 0; is_free && row <= std::min(z + 1, rows - 1); ++row)
      for (std::uint32_t cell = x > 0 ? x - 1 : 0; is_free && cell <= std::min(x + 1, columns - 1); ++cell)
        for (std::int32_t spot = first_in_cell[row * columns + cell]; is_free && spot >= 0;
             spot = next_in_cell[static_cast<std::size_t>(spot)])
          is_free = glm::distance(spots[static_cast<std::size_t>(spot)], dart) >= apart;
    if (!is_free) continue;
    next_in_cell.push_back(first_in_cell[z * columns + x]);
    first_in_cell[z * columns + x] = static_cast<std::int32_t>(spots.size());
    spots.push_back(dart);
  }
  return spots;
}

// The range of steps along a line, each `step` long from `from`, that can lie in a strip; empty where `first` is
// greater than `last`. It is a little too wide, since rounding differs between here and the place of a spot.
struct Steps {
  float first, last;
};

// Clips a line to a strip: the numbers of the steps of size `step` from the point `from` that are inside, at most
// `most` to each side.
Steps within(const Strip& strip, const glm::vec2& from, const glm::vec2& step, float most) {
  const float tolerance = 1e-5f * (glm::length(strip.size) + glm::length(strip.low));
  Steps steps{-most, most};
  for (int axis = 0; axis < 2; ++axis) {
    const float low = strip.low[axis] - tolerance - from[axis], high = low + strip.size[axis] + 2 * tolerance;
    if (std::abs(step[axis]) * most < tolerance) {
      // The line is parallel to the edge: all of it is inside, or nothing.
      if (low > tolerance || high < -tolerance) return {1, 0};
      continue;
    }
    const float at_low = low / step[axis], at_high = high / step[axis];
    steps.first = std::max(steps.first, std::min(at_low, at_high));
    steps.last = std::min(steps.last, std::max(at_low, at_high));
  }
  return {std::max(std::floor(steps.first) - 1, -most), std::min(std::ceil(steps.last) + 1, most)};
}

// A spot in rows: the signed numbers of its row and of its place in the row, both 0 in the middle, and the spot on the
// ground.
struct InRow {
  std::int32_t row, place;
  glm::vec2 at;
};

// Keeps `count` spots: those of the rows nearest to the middle, and in the last of these rows those nearest to its
// middle. The result is sorted from the back.
void keep_middle(std::vector<InRow>& spots, std::uint32_t count) {
  if (spots.size() > count) {
    std::sort(spots.begin(), spots.end(), [](const InRow& a, const InRow& b) {
      return std::tuple(std::abs(a.row), a.row, std::abs(a.place), a.place) <
             std::tuple(std::abs(b.row), b.row, std::abs(b.place), b.place);
    });
    spots.resize(count);
  }
  std::sort(spots.begin(), spots.end(),
            [](const InRow& a, const InRow& b) { return std::tie(a.row, a.place) < std::tie(b.row, b.place); });
}

// Places parallel rows over the whole strip, symmetrically about its middle, and adds jitter. If `count` is the plan's,
// it fills rows from the back; a smaller count stays in the middle; 0 means as many as have room.
void place_in_rows(const Strip& strip, const Layer& layer, std::uint32_t count, const RandomDraws& draws,
                   Spots& spots) {
  const SinCos turn = sincos_degrees(layer.towards);
  const glm::vec2 along(turn.cosine, turn.sine), across(-turn.sine, turn.cosine);
  const glm::vec2 middle = strip.at(0.5f, 0.5f);
  const float reach = 0.5f * glm::length(strip.size);
  const bool is_reduced = count > 0 && (layer.count == 0 || count < layer.count);
  const std::uint32_t most = count > 0 && !is_reduced ? std::min(count, most_plants) : most_plants + 1;
  // Rows and places to each side of the middle one, as many as fit on the shorter side: a symmetrical field.
  const auto rows = static_cast<std::int32_t>(std::min(reach / layer.apart, 1e5f));
  const float places = std::floor(std::min(reach / layer.along, 1e5f));
  std::vector<InRow> found;
  for (std::int32_t i = 0; i <= 2 * rows && found.size() < (is_reduced ? count : most); ++i) {
    // 0, −1, 1, −2 … where the rows nearest to the middle are needed, and else from the back.
    const std::int32_t row = !is_reduced ? i - rows : i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const glm::vec2 row_middle = middle + layer.apart * static_cast<float>(row) * across;
    const Steps steps = within(strip, row_middle, layer.along * along, places);
    const auto last = static_cast<std::int32_t>(steps.last);
    for (auto place = static_cast<std::int32_t>(steps.first); place <= last && (is_reduced || found.size() < most);
         ++place) {
      const glm::vec2 spot = row_middle + layer.along * static_cast<float>(place) * along;
      if (strip.contains(spot)) found.push_back({row, place, spot});
    }
  }
  if (is_reduced) keep_middle(found, count);
  for (const auto& [row, place, spot] : found) {
    const std::uint64_t address = hash_combine(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(place));
    const glm::vec2 offset(2 * draws.unit(address) - 1, 2 * draws.unit(hash_combine(address, 1)) - 1);
    spots.at.push_back(glm::clamp(spot + layer.jitter * offset, strip.low, strip.low + strip.size));
    spots.row.emplace_back(row, place);
  }
}

// The value of a range at a random value `unit` in [0, 1).
float value_at(const ValueRange& range, float unit) { return range.from + (range.to - range.from) * unit; }

// Draws the scale, the seed and the settings of the plant at an address.
void draw(Placement& plant, const Kind& kind, std::uint64_t seed, std::uint64_t address) {
  static const std::uint64_t own_stream = hash_text("stand plant"), shared_stream = hash_text("stand alike");
  plant.seed = static_cast<std::uint32_t>(random_bits(seed, own_stream, address) >> 32);
  if (kind.seeds > 0) {
    const std::uint64_t specimen = (random_bits(seed, shared_stream, address) >> 32) * kind.seeds >> 32;
    plant.seed = static_cast<std::uint32_t>(random_bits(hash_combine(seed, shared_stream), plant.kind, specimen) >> 32);
  }
  plant.scale = value_at(kind.scale, random_unit(seed, hash_text("stand scale"), address));
  // Drawn by the plant's own seed: plants of one seed are alike.
  for (std::size_t i = 0; i < kind.settings.size(); ++i) {
    const Setting& setting = kind.settings[i];
    plant.settings.push_back(setting.word.empty()
                                 ? value_at(setting.range, random_unit(plant.seed, hash_text("stand setting"), i))
                                 : std::numeric_limits<float>::quiet_NaN());
  }
}

// Whether a row's plant faces along the row and not the other way, by a random value `unit` in [0, 1). Plants tied to
// wires all face the same way, so that they leave no gap.
bool faces_along_row(const Layer& layer, float unit) { return layer.trellis.has_value() || unit < 0.5f; }

// Chooses a kind for a plant on the ground, with probabilities by the kinds' shares, from a random value `unit` in [0,
// 1). Adds the kind's index in `kinds` to `number`.
const Kind& chosen(const std::vector<Kind>& kinds, float unit, std::uint32_t& number) {
  float sum = 0;
  for (const Kind& kind : kinds) sum += kind.attached ? 0 : kind.share;
  float left = unit * sum;
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i].attached || kinds[i].share <= 0) continue;
    last = i;
    left -= kinds[i].share;
    if (left < 0) break;
  }
  number += last;
  return kinds[last];
}

}  // namespace

// The z of the middle of a layer's strip, in metres.
float middle_of(const Layer& layer, const Ground& ground) { return strip_of(layer, ground).at(0.5f, 0.5f).y; }

// Chooses `count` spots for a layer's plants by its spacing, and counts those for which there was none. `place` is the
// layer's index and selects its random values.
Spots spots_of(const Layer& layer, std::uint32_t count, const Ground& ground, std::uint64_t seed, std::uint32_t place) {
  const Strip strip = strip_of(layer, ground);
  const RandomDraws draws(seed, "stand spot", place);
  Spots spots;
  switch (layer.spacing) {
    case Spacing::chance:
      spots.at = random_spots(strip, count, draws);
      break;
    case Spacing::strata:
      spots.at = stratified_spots(strip, count, draws);
      break;
    case Spacing::blue: {
      const float default_distance = 0.7f * std::sqrt(strip.size.x * strip.size.y / static_cast<float>(count));
      spots.at = blue_noise_spots(strip, count, layer.apart > 0 ? layer.apart : default_distance, draws);
      break;
    }
    case Spacing::rows:
      place_in_rows(strip, layer, count, draws, spots);
      break;
  }
  spots.missing = count - std::min(count, static_cast<std::uint32_t>(spots.at.size()));
  return spots;
}

namespace {

// Adds the plants that grow on `parent`, an index in `plants`: those of the `attached` kinds that follow the parent's
// kind. `first_kind` is the number of the layer's first kind; in rows they spread along the row, else over a disc.
void attach(std::vector<Placement>& plants, const std::vector<Kind>& kinds, std::uint32_t first_kind,
            std::size_t parent, bool in_row, std::uint64_t seed, std::uint64_t address) {
  for (std::uint32_t i = plants[parent].kind - first_kind + 1; i < kinds.size() && kinds[i].attached; ++i) {
    const Kind& kind = kinds[i];
    const std::uint64_t kind_address = hash_combine(address, i);
    const RandomDraws draws(seed, "stand borne", kind_address);
    const auto count = static_cast<std::uint32_t>(value_at({kind.each.from, kind.each.to + 1}, draws.unit(0)));
    const Placement host = plants[parent];
    for (std::uint32_t k = 0; k < std::min(count, static_cast<std::uint32_t>(kind.each.to)); ++k) {
      if (plants.size() > most_plants) return;
      Placement attached_plant;
      attached_plant.layer = host.layer;
      attached_plant.kind = first_kind + i;
      attached_plant.parent = static_cast<std::int32_t>(parent);
      draw(attached_plant, kind, seed, hash_combine(kind_address, k + 1));
      attached_plant.turn = 360 * draws.unit(8 * k + 1);
      const SinCos direction = sincos_degrees(in_row ? host.turn : 360 * draws.unit(8 * k + 2));
      // In rows evenly along the parent, each in a part of it; else evenly over a disc about the parent.
      const float share = (static_cast<float>(k) + draws.unit(8 * k + 3)) / static_cast<float>(count);
      const float outwards = host.scale * kind.reach * (in_row ? 2 * share - 1 : std::sqrt(draws.unit(8 * k + 3)));
      const float sideways = in_row ? host.scale * 0.05f * (2 * draws.unit(8 * k + 4) - 1) : 0;
      const float height = host.scale * value_at(kind.high, draws.unit(8 * k + 5));
      attached_plant.at = host.at + glm::vec3(outwards * direction.cosine - sideways * direction.sine, height,
                                              outwards * direction.sine + sideways * direction.cosine);
      plants.push_back(std::move(attached_plant));
    }
  }
}

}  // namespace

// Places all plants of a plan: on the ground layer by layer, then those attached to them. `requested` plants are
// divided among the layers in proportion to their counts; 0 keeps the plan's counts.
Result<std::vector<Placement>> place(const Plan& plan, const Relief& relief, std::uint64_t seed,
                                     std::uint32_t requested, std::vector<std::string>& notes) {
  const auto too_many = [] { return Diagnostic{Reason::limit, message(messages::stand::too_many_plants), 0, 0}; };
  // The plan's count of each layer; rows without one have as many plants as there is room for.
  std::vector<std::uint32_t> counts;
  std::uint32_t all = 0;
  for (std::uint32_t i = 0; i < plan.layers.size(); ++i) {
    const Layer& layer = plan.layers[i];
    counts.push_back(layer.count > 0 ? layer.count
                                     : static_cast<std::uint32_t>(spots_of(layer, 0, plan.ground, seed, i).at.size()));
    all += counts.back();
    if (all > most_plants) return too_many();
  }
  std::vector<Placement> plants;
  struct GroundPlant {
    std::uint32_t layer, first_kind;
    std::uint64_t address;
  };
  std::vector<GroundPlant> ground_plants;
  std::uint32_t first_kind = 0;
  // Counts are differences of a rounded running sum, so that they add up to the requested number.
  std::uint64_t before = 0;
  for (std::uint32_t i = 0; i < plan.layers.size(); ++i) {
    const Layer& layer = plan.layers[i];
    const std::uint64_t upto = before + counts[i];
    const std::uint32_t count = requested == 0 || all == 0
                                    ? counts[i]
                                    : static_cast<std::uint32_t>(upto * requested / all - before * requested / all);
    before = upto;
    if (count == 0) {
      if (counts[i] > 0) notes.push_back(message(messages::stand::none_left, layer.place.line));
      first_kind += static_cast<std::uint32_t>(layer.kinds.size());
      continue;
    }
    const Spots spots = spots_of(layer, count, plan.ground, seed, i);
    if (spots.missing > 0) notes.push_back(message(messages::stand::ground_full, spots.missing, count));
    const RandomDraws draws(seed, "stand kind", i);
    for (std::uint32_t k = 0; k < spots.at.size(); ++k) {
      Placement plant;
      plant.layer = i;
      if (!spots.row.empty()) plant.row = spots.row[k].x, plant.place = spots.row[k].y;
      plant.kind = first_kind;
      const Kind& kind = chosen(layer.kinds, draws.unit(2 * k), plant.kind);
      plant.at = {spots.at[k].x, relief.at(spots.at[k].x, spots.at[k].y), spots.at[k].y};
      const std::uint64_t address = hash_combine(i, k);
      draw(plant, kind, seed, address);
      const float unit = draws.unit(2 * k + 1);
      plant.turn =
          layer.spacing != Spacing::rows ? 360 * unit : layer.towards + (faces_along_row(layer, unit) ? 0 : 180);
      plants.push_back(std::move(plant));
      ground_plants.push_back({i, first_kind, address});
    }
    first_kind += static_cast<std::uint32_t>(layer.kinds.size());
  }
  // Attached plants come after all plants on the ground.
  for (std::size_t i = 0; i < ground_plants.size(); ++i) {
    const Layer& layer = plan.layers[ground_plants[i].layer];
    attach(plants, layer.kinds, ground_plants[i].first_kind, i, layer.spacing == Spacing::rows, seed,
           ground_plants[i].address);
    if (plants.size() > most_plants) return too_many();
  }
  return plants;
}

}  // namespace panicle::stand
